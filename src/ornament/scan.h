// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/quoted.h"
#include "base/syntax_error.h"

namespace edaha {

// Larger numbers are refused: beyond any drawing, and far enough from the end of double's range
// that sums and squares of a million of them stay finite.
inline constexpr double kLargestNumber = 1e9;

// Reads SVG's small grammars (path data, transforms, points, lengths, colours) from the left.
// Keeps a view of the text. Locale-free.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    bool at_end() const { return at_ == text_.size(); }
    std::size_t offset() const { return at_; }
    char peek() const { return at_end() ? '\0' : text_[at_]; }
    char take() { return text_[at_++]; }  // not at the end
    bool take(char c);
    void skip_space();
    bool skip_comma();             // space, at most one comma, space; whether there was a comma
    std::string_view take_word();  // letters, digits, - and _
    std::string_view take_until(char end);  // without it; it is passed if it is there
    bool number_follows() const;

    // None, and nothing read, if no number stands here. An exponent needs digits: "2em" is 2.
    // Throws SyntaxError beyond kLargestNumber.
    std::optional<double> take_number();

    // What stands here, quoted, for messages: a word or one sign; "the end" at the end.
    std::string here() const;
    std::string sign_here() const;  // one sign, also of a word

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

// ASCII letters only.
std::string lower_case(std::string_view text);

}  // namespace edaha
