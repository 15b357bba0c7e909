// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace edaha {
namespace {

constexpr double kPowerOfTen[kMostDecimals + 1] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

// Every whole number up to here is a double.
constexpr double kLargestUnits = 9007199254740992.0;

// Digits of `number`, written backwards so that they end at `end`. Returns their start.
char* write_digits_before(char* end, std::uint64_t number) {
    std::uint64_t rest = number;
    while (rest > 0xffffffffu) {
        *--end = static_cast<char>('0' + rest % 10);
        rest /= 10;
    }
    auto low = static_cast<std::uint32_t>(rest);  // 32-bit division is several times quicker
    do {
        *--end = static_cast<char>('0' + low % 10);
        low /= 10;
    } while (low != 0);
    return end;
}

}  // namespace

std::int64_t to_units(double value, int decimals) {
    assert(decimals >= 0 && decimals <= kMostDecimals);
    const double scaled = value * kPowerOfTen[decimals];
    if (!(std::abs(scaled) < kLargestUnits)) {
        if (std::isnan(scaled)) return 0;
        return static_cast<std::int64_t>(std::copysign(kLargestUnits, scaled));
    }
    const auto whole = static_cast<std::int64_t>(scaled);
    const double rest = scaled - static_cast<double>(whole);  // exact
    return whole + (rest >= 0.5) - (rest <= -0.5);
}

char* write_units(char* out, std::int64_t units, int decimals) {
    if (units < 0) *out++ = '-';
    auto magnitude = static_cast<std::uint64_t>(units < 0 ? -units : units);
    while (decimals > 0 && magnitude % 10 == 0) {
        magnitude /= 10;
        --decimals;
    }
    char digits[kLongestNumber];
    char* const end = digits + kLongestNumber;
    const char* first = write_digits_before(end, magnitude);
    const int before_point = static_cast<int>(end - first) - decimals;
    if (before_point > 0) out = std::copy_n(first, before_point, out);
    if (decimals == 0) return out;
    *out++ = '.';
    if (before_point < 0) out = std::fill_n(out, -before_point, '0');
    return std::copy(first + std::max(before_point, 0), static_cast<const char*>(end), out);
}

void append_number(std::string& text, double value, int decimals) {
    char buffer[kLongestNumber];
    const char* const end = write_units(buffer, to_units(value, decimals), decimals);
    text.append(buffer, static_cast<std::size_t>(end - buffer));
}

std::string number_text(double value, int decimals) {
    std::string text;
    append_number(text, value, decimals);
    return text;
}

std::optional<double> parse_number(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    if (plus) text.remove_prefix(1);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace edaha
