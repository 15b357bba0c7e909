// SPDX-License-Identifier: MIT
#include "mesh/text_cursor.h"

#include <charconv>

#include "base/quoted.h"

namespace edaha {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::size_t from)
    : begin_(text.data()), at_(begin_ + from), end_(begin_ + text.size()) {
    if (from == 0 && text.starts_with("\xEF\xBB\xBF")) at_ += 3;
}

bool TextCursor::skip_continuation() {
    if (end_ - at_ < 2 || *at_ != '\\' || !is_line_end(at_[1])) return false;
    const bool both = end_ - at_ > 2 && at_[1] == '\r' && at_[2] == '\n';
    at_ += both ? 3 : 2;
    return true;
}

bool TextCursor::line_ends() {
    while (at_ != end_) {
        if (is_blank(*at_)) {
            ++at_;
        } else if (!skip_continuation()) {
            break;
        }
    }
    return at_ == end_ || is_line_end(*at_) || *at_ == '#';
}

void TextCursor::next_line() {
    while (at_ != end_ && !is_line_end(*at_)) {
        if (!skip_continuation()) ++at_;
    }
    if (at_ != end_ && *at_ == '\r' && end_ - at_ > 1 && at_[1] == '\n') ++at_;
    if (at_ != end_) ++at_;
}

bool TextCursor::word_ends() const {
    return at_ == end_ || is_blank(*at_) || is_line_end(*at_) || *at_ == '#' || *at_ == '\\';
}

std::string_view TextCursor::word() {
    if (line_ends()) return {};
    const char* const from = at_++;
    while (!word_ends())
        ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
}

std::string_view TextCursor::line_rest() {
    const char* const from = at_;
    while (at_ != end_ && !is_line_end(*at_))
        ++at_;
    return trimmed({from, static_cast<std::size_t>(at_ - from)});
}

double TextCursor::number() {
    if (line_ends()) throw SyntaxError(offset(), "a number is missing");
    const char* const from = at_;
    if (*at_ == '+') ++at_;
    double value = 0;
    const auto [stop, error] = std::from_chars(at_, end_, value);
    at_ = stop;
    if (error == std::errc::result_out_of_range && word_ends()) {
        const std::string text = quoted({from, static_cast<std::size_t>(stop - from)});
        throw SyntaxError(offset() - static_cast<std::size_t>(stop - from),
                          text + " is too large or too small (expected 1e-307 to 1e308, or 0)");
    }
    if (error != std::errc{} || !word_ends()) {
        const auto begin = static_cast<std::size_t>(from - begin_);
        throw SyntaxError(begin, word_at(begin) + " is not a number");
    }
    return value;
}

std::optional<std::int64_t> TextCursor::integer() {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{}) return std::nullopt;
    at_ = stop;
    return value;
}

std::string TextCursor::word_at(std::size_t offset) const {
    TextCursor cursor = *this;
    cursor.at_ = begin_ + offset;
    return quoted(cursor.word());
}

}  // namespace edaha
