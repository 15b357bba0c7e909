// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace edaha {

// How the files of variants are named: "{style}-{seed:04}". Fields: style, seed, index (from 1 over
// the whole run), family, palette, and any parameter ("{growth.energy}"); ":04" fills whole numbers
// up with zeros. A / makes folders.
class NamePattern {
  public:
    // Errors: UsageError for an unknown field, or a pattern that is no path within a folder.
    explicit NamePattern(const std::string& text);

    // The text of a field: "seed", "growth.energy".
    using FieldText = std::function<std::string(const std::string& field)>;

    // A path without ending. Of the fields' texts, / and white space become - and _: they make no
    // folders. Errors: UsageError if it leads out of the folder, or is too long for a file's name.
    std::string name(const FieldText& field_text) const;

  private:
    struct Piece {
        std::string text;   // as it stands, before the field
        std::string field;  // empty: none
        std::size_t digits = 0;
    };
    void add_field(const std::string& field, const std::string& text);

    std::string text_;
    std::vector<Piece> pieces_;
};

}  // namespace edaha
