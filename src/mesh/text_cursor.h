// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/syntax_error.h"

namespace edaha {

// Walks the words of a text that is read by lines. A backslash before a line's end is a blank;
// '#' ends what is read of a line. A byte order mark is passed. Keeps a view of the text.
class TextCursor {
  public:
    explicit TextCursor(std::string_view text, std::size_t from = 0);

    bool at_end() const { return at_ == end_; }
    std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    char peek() const { return at_end() ? '\0' : *at_; }
    void advance() { ++at_; }  // not at the end

    // Whether nothing follows on this line but blanks and a comment. Passes the blanks.
    bool line_ends();
    void next_line();  // to the beginning of the next line, or the end

    std::string_view word();       // up to a blank or the line's end; passes blanks before it
    std::string_view line_rest();  // without blanks at both ends, comments included
    double number();               // also nan and inf; throws SyntaxError if there is none
    std::optional<std::int64_t> integer();  // right here; none if there is none
    bool word_ends() const;

    // The word that the offset stands in, quoted, for messages.
    std::string word_at(std::size_t offset) const;

  private:
    bool skip_continuation();

    const char* begin_;
    const char* at_;
    const char* end_;
};

}  // namespace edaha
