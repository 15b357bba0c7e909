// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

// A file of the catalogue or of the user.
struct SourceText {
    std::string text;
    std::string origin;            // for messages: its path, or "built-in styles/oak.xml"
    std::filesystem::path folder;  // where relative paths in it begin; empty: the working folder
};

// Styles and leaves by name. Searched in this order: a path (it ends in .xml or .svg, or holds a /
// and leads to a file), the user's folder (styles/NAME.xml, leaves/NAME.svg), what is built in.
// Names hold no ending: "cherry", "paper/energy-a-100-plain".
// Errors: InputError for an unknown name (with the nearest), IoError for a file that can't be read.
class Catalogue {
  public:
    // With an empty folder only paths and built-in names are known.
    explicit Catalogue(std::filesystem::path user_folder = {});

    // A relative path begins at `folder`.
    SourceText find_style(const std::string& name, const std::filesystem::path& folder = {}) const;
    SourceText find_leaf(const std::string& name) const;
    bool has_leaf(const std::string& name) const;

    std::vector<std::string> style_names() const;  // sorted, each once
    std::vector<std::string> leaf_names() const;

  private:
    std::filesystem::path user_folder_;
};

// A reference to a drawing that stands in a file of `folder`, as it is seen from the working
// folder.
std::string resolve_leaf(const std::string& reference, const std::filesystem::path& folder);

// Small letters, digits and single hyphens between them.
bool is_name(std::string_view text);

}  // namespace edaha
