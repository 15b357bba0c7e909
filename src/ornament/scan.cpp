// SPDX-License-Identifier: MIT
#include "ornament/scan.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/utf8.h"

namespace edaha {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f";

bool is_space(char c) {
    return kSpace.find(c) != std::string_view::npos;
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_word(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
}

// from_chars says "out of range" for 1e-999 too, which is 0 to us.
bool vanishes(std::string_view number) {
    const std::size_t exponent = number.find_first_of("eE");
    if (exponent != std::string_view::npos) return number[exponent + 1] == '-';
    return number.front() == '0' || number.front() == '.';
}

}  // namespace

bool Scanner::take(char c) {
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
}

void Scanner::skip_space() {
    while (at_ < text_.size() && is_space(text_[at_]))
        ++at_;
}

bool Scanner::skip_comma() {
    skip_space();
    const bool comma = take(',');
    if (comma) skip_space();
    return comma;
}

std::string_view Scanner::take_word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_word(text_[at_]))
        ++at_;
    return text_.substr(begin, at_ - begin);
}

std::string_view Scanner::take_until(char end) {
    const std::size_t begin = at_;
    at_ = std::min(text_.find(end, at_), text_.size());
    const std::string_view taken = text_.substr(begin, at_ - begin);
    take(end);
    return taken;
}

bool Scanner::number_follows() const {
    std::size_t at = at_;
    if (at < text_.size() && (text_[at] == '+' || text_[at] == '-')) ++at;
    if (at < text_.size() && text_[at] == '.') ++at;
    return at < text_.size() && is_digit(text_[at]);
}

std::optional<double> Scanner::take_number() {
    if (!number_follows()) return std::nullopt;
    const std::size_t begin = at_;
    const bool negative = take('-');
    if (!negative) take('+');
    double value = 0;
    const std::string_view digits = text_.substr(at_);
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const auto length = static_cast<std::size_t>(end - digits.data());
    const bool out_of_range = fault == std::errc::result_out_of_range;
    if (out_of_range && vanishes(digits.substr(0, length))) {
        value = 0;
    } else if (out_of_range || value > kLargestNumber) {
        at_ += length;
        const std::string_view number = text_.substr(begin, at_ - begin);
        throw SyntaxError(begin, quoted(number) + " is too large (expected at most 1e9)");
    }
    at_ += length;
    return negative ? -value : value;
}

std::string Scanner::here() const {
    if (at_end() || !is_word(peek())) return sign_here();
    Scanner rest = *this;
    return quoted(rest.take_word());
}

std::string Scanner::sign_here() const {
    if (text_.empty()) return "''";
    if (at_end()) return "the end";
    const std::string_view rest = text_.substr(at_);
    return quoted(rest.substr(0, first_character(rest).bytes));
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

}  // namespace edaha
