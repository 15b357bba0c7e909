// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

// The text of an element, put together from its pieces, that remembers where in the file each of
// its bytes stands: references (&gt;) and CDATA may come between. So what is wrong with an L-system
// is said with its place in the style file. Linear.
class RulesText {
  public:
    struct Wrong {
        std::size_t offset;  // in the file's text
        std::string message;
    };

    // `value`, as the XML reader has made it of what begins at `offset`.
    void add(std::string_view file, std::size_t offset, std::string_view value, bool is_cdata);

    const std::string& text() const { return text_; }

    // Of the L-system; none for an empty text.
    std::vector<Wrong> problems() const;

  private:
    std::size_t offset_of(int line, int column) const;

    std::string text_;
    std::vector<std::size_t> offsets_;  // of each byte of text_, and of its end
    std::size_t end_ = 0;
};

}  // namespace edaha
