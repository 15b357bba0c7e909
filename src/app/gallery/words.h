// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

// Running text of a gallery: *emphasis*, `code` and [links](address), as in Markdown, and a
// backslash before what is meant as it stands. Marks without their partner are plain characters.
struct Words {
    enum class Kind { plain, emphasis, code, link };
    Kind kind = Kind::plain;
    std::string text;
    std::string address = {};  // of a link
    bool operator==(const Words&) const = default;
};
using Line = std::vector<Words>;

// White space of any kind and length becomes one blank.
Line read_line(std::string_view text);

// A line for each paragraph: blank lines part them.
std::vector<Line> read_paragraphs(std::string_view text);

// The first address that a page should not lead to: one with another scheme than http, https and
// mailto. Empty if there is none.
std::string unsafe_address(const Line& line);

std::string to_plain(const Line& line);
std::string to_html(const Line& line);

// On one line, also as a table's cell; what is plain stays so, whatever it looks like.
std::string to_markdown(const Line& line);

std::string html_text(std::string_view text);  // for contents and for values in double quotes
std::string markdown_text(std::string_view text);
std::string markdown_code(std::string_view text);

}  // namespace edaha
