// SPDX-License-Identifier: MIT
#include "app/gallery/words.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace edaha {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

bool is_space(char c) {
    return kSpace.find(c) != std::string_view::npos;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string squeezed(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (!is_space(c)) {
            result += c;
        } else if (!result.empty() && result.back() != ' ') {
            result += ' ';
        }
    }
    if (result.ends_with(' ')) result.pop_back();
    return result;
}

class LineReader {
  public:
    explicit LineReader(std::string_view text) : text_(text) {}

    Line read() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\\' && at_ + 1 < text_.size() && is_mark(text_[at_ + 1])) {
                plain_ += text_[at_ + 1];
                at_ += 2;
            } else if (!(c == '*' && take_emphasis()) && !(c == '`' && take_code()) &&
                       !(c == '[' && take_link())) {
                plain_ += c;
                ++at_;
            }
        }
        end_plain();
        return std::move(line_);
    }

  private:
    static bool is_mark(char c) { return std::string_view("*`[]()\\").find(c) != kNone; }

    // What stands between here and the next `end`, if that is something.
    std::optional<std::string> until(char end) const {
        const std::size_t close = text_.find(end, at_ + 1);
        if (close == kNone || close == at_ + 1) return std::nullopt;
        return std::string(text_.substr(at_ + 1, close - at_ - 1));
    }

    bool take(Words words, std::size_t length) {
        end_plain();
        line_.push_back(std::move(words));
        at_ += length;
        return true;
    }

    bool take_emphasis() {
        const auto inside = until('*');
        if (!inside || is_space(inside->front()) || is_space(inside->back())) return false;
        return take({Words::Kind::emphasis, *inside}, inside->size() + 2);
    }

    bool take_code() {
        const auto inside = until('`');
        return inside && take({Words::Kind::code, *inside}, inside->size() + 2);
    }

    bool take_link() {
        const auto name = until(']');
        if (!name) return false;
        const std::size_t open = at_ + name->size() + 2;
        if (open >= text_.size() || text_[open] != '(') return false;
        const std::size_t close = text_.find(')', open);
        if (close == kNone || close == open + 1) return false;
        std::string address(text_.substr(open + 1, close - open - 1));
        return take({Words::Kind::link, *name, std::move(address)}, close + 1 - at_);
    }

    void end_plain() {
        if (!plain_.empty()) line_.push_back({Words::Kind::plain, plain_});
        plain_.clear();
    }

    static constexpr std::size_t kNone = std::string_view::npos;
    std::string_view text_;
    std::size_t at_ = 0;
    std::string plain_;
    Line line_;
};

// "https" of "https://a.b"; empty for a path.
std::string scheme_of(const std::string& address) {
    const std::size_t colon = address.find(':');
    const bool is_path = colon == std::string::npos || address.find_first_of("/?#") < colon;
    return is_path ? "" : address.substr(0, colon);
}

// An address as Markdown and HTML take it: without what would end it.
std::string plain_address(const std::string& address) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string result;
    for (const char c : address) {
        if (std::string_view(" <>\"()|`\\").find(c) == std::string_view::npos) {
            result += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            result += {'%', kHex[byte / 16U], kHex[byte % 16U]};
        }
    }
    return result;
}

// With a backslash where the text would begin a list, a heading or a quotation.
std::string as_paragraph(std::string text) {
    if (text.empty()) return text;
    if (std::string_view("#+->=~").find(text.front()) != std::string_view::npos) return '\\' + text;
    const auto after = std::ranges::find_if_not(text, is_digit);
    const bool counts = after != text.begin() && after != text.end();
    if (counts && (*after == '.' || *after == ')')) text.insert(after, '\\');
    return text;
}

}  // namespace

Line read_line(std::string_view text) {
    return LineReader(squeezed(text)).read();
}

std::vector<Line> read_paragraphs(std::string_view text) {
    std::vector<Line> paragraphs;
    std::string paragraph;
    const auto end_paragraph = [&] {
        Line line = read_line(paragraph);
        if (!line.empty()) paragraphs.push_back(std::move(line));
        paragraph.clear();
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        if (std::ranges::all_of(line, is_space)) end_paragraph();
        paragraph += std::string(line) + ' ';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    end_paragraph();
    return paragraphs;
}

std::string unsafe_address(const Line& line) {
    constexpr std::array<std::string_view, 4> kSafe{"", "http", "https", "mailto"};
    for (const Words& words : line) {
        if (std::ranges::count(kSafe, scheme_of(words.address)) == 0) return words.address;
    }
    return "";
}

std::string to_plain(const Line& line) {
    std::string text;
    for (const Words& words : line)
        text += words.text;
    return text;
}

std::string to_html(const Line& line) {
    std::string text;
    for (const Words& words : line) {
        const std::string inside = html_text(words.text);
        switch (words.kind) {
            case Words::Kind::plain:
                text += inside;
                break;
            case Words::Kind::emphasis:
                text += "<em>" + inside + "</em>";
                break;
            case Words::Kind::code:
                text += "<code>" + inside + "</code>";
                break;
            case Words::Kind::link:
                text += "<a href=\"" + html_text(plain_address(words.address)) + "\">" + inside +
                        "</a>";
        }
    }
    return text;
}

std::string to_markdown(const Line& line) {
    std::string text;
    for (const Words& words : line) {
        switch (words.kind) {
            case Words::Kind::plain:
                text += markdown_text(words.text);
                break;
            case Words::Kind::emphasis:
                text += '*' + markdown_text(words.text) + '*';
                break;
            case Words::Kind::code:
                text += markdown_code(words.text);
                break;
            case Words::Kind::link:
                text += '[' + markdown_text(words.text) + "](" + plain_address(words.address) + ')';
        }
    }
    return as_paragraph(std::move(text));
}

std::string html_text(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '&') {
            escaped += "&amp;";
        } else if (c == '<') {
            escaped += "&lt;";
        } else if (c == '>') {
            escaped += "&gt;";
        } else if (c == '"') {
            escaped += "&quot;";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

std::string markdown_text(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (std::string_view("\\`*_[]<>|&~").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string markdown_code(std::string_view text) {
    std::string inside;
    std::size_t longest = 0, run = 0;
    for (const char c : text) {
        run = c == '`' ? run + 1 : 0;
        longest = std::max(longest, run);
        inside += c;
    }
    const std::string fence(longest + 1, '`');
    const std::string blank = longest > 0 ? " " : "";
    return fence + blank + inside + blank + fence;
}

}  // namespace edaha
