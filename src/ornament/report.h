// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace edaha::svg {

// Something in an XML source, cheap to note and found again only when it is reported.
struct Spot {
    std::size_t node = 0;   // offset of an element's name or of a text
    std::string attribute;  // of that element; empty: the element, or `index` in the text
    bool in_value = false;  // the attribute's value, else its name
    std::size_t index = 0;  // byte of the value

    auto operator<=>(const Spot&) const = default;
};

inline Spot attribute_spot(std::size_t node, std::string attribute) {
    return {node, std::move(attribute), false, 0};
}
inline Spot value_spot(std::size_t node, std::string attribute, std::size_t index = 0) {
    return {node, std::move(attribute), true, index};
}

// Collects what is wrong with a text and what of it is not kept. The same message at the same spot
// (a drawing used twice) counts once; of each kind 100 are listed, and then that there are more.
class Report {
  public:
    // Keeps views of `text`.
    Report(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    void error(const Spot& spot, const std::string& message) { note(errors_, spot, message); }
    void warn(const Spot& spot, const std::string& message) { note(warnings_, spot, message); }

    [[noreturn]] void fail(const Spot& spot, const std::string& message);

    // Further warnings would not be listed.
    bool is_full() const;

    bool failed() const { return !errors_.empty(); }
    void throw_if_failed() const;

    // In the order of the text.
    std::vector<Problem> warnings() const { return problems(warnings_); }

  private:
    struct Note {
        Spot spot;
        std::string message;
        auto operator<=>(const Note&) const = default;
    };
    using Notes = std::set<Note>;

    static void note(Notes& notes, const Spot& spot, const std::string& message);
    std::vector<Problem> problems(const Notes& notes) const;
    std::size_t offset(const Spot& spot) const;

    std::string_view text_;
    std::string file_;
    Notes errors_;
    Notes warnings_;
};

}  // namespace edaha::svg
