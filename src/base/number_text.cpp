// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>

namespace edaha {
namespace {

constexpr double kPowerOfTen[kMostDecimals + 1] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

// Every whole number up to here is a double.
constexpr double kLargestUnits = 9007199254740992.0;

constexpr std::uint64_t kWholePowers[] = {1ull,
                                          10ull,
                                          100ull,
                                          1000ull,
                                          10000ull,
                                          100000ull,
                                          1000000ull,
                                          10000000ull,
                                          100000000ull,
                                          1000000000ull,
                                          10000000000ull,
                                          100000000000ull,
                                          1000000000000ull,
                                          10000000000000ull,
                                          100000000000000ull,
                                          1000000000000000ull,
                                          10000000000000000ull};

// 1233 / 4096 is log10(2), close enough for 54 bits; the comparison mends the rest.
int count_digits(std::uint64_t number) {
    const int bits = std::bit_width(number | 1);
    const int guess = bits * 1233 >> 12;
    return guess + (number >= kWholePowers[guess]) + (number == 0);
}

// The last `count` digits of `number`, so that they end at `end`. Returns what is left of it.
std::uint64_t write_digits_before(char* end, std::uint64_t number, int count) {
    for (; count > 0 && number > 0xffffffffu; --count) {
        *--end = static_cast<char>('0' + number % 10);
        number /= 10;
    }
    if (count == 0) return number;
    auto low = static_cast<std::uint32_t>(number);  // 32-bit division is several times quicker
    for (; count > 0; --count) {
        *--end = static_cast<char>('0' + low % 10);
        low /= 10;
    }
    return low;
}

// Digit by digit, for any number.
char* write_long(char* out, std::uint64_t magnitude, int decimals) {
    while (decimals > 0 && magnitude % 10 == 0) {
        magnitude /= 10;
        --decimals;
    }
    const int digits = count_digits(magnitude);
    if (decimals == 0) {
        write_digits_before(out + digits, magnitude, digits);
        return out + digits;
    }
    const int before_point = digits > decimals ? digits - decimals : 0;
    char* const end = out + before_point + 1 + decimals;
    const std::uint64_t whole = write_digits_before(end, magnitude, decimals);
    out[before_point] = '.';
    write_digits_before(out + before_point, whole, before_point);
    return end;
}

// The four digits of 0 to 9999, a byte each, the first one in the lowest.
struct FourDigits {
    std::uint32_t of[10000] = {};

    constexpr FourDigits() {
        for (std::uint32_t i = 0; i < 10000; ++i)
            of[i] = i / 1000 | i / 100 % 10 << 8 | i / 10 % 10 << 16 | i % 10 << 24;
    }
};

constexpr FourDigits kFourDigits;

// For so many decimals, of seven digits in a word and a clear byte before them: the bytes that lie
// after the point, and what makes text of it once those before the point have moved up by one.
struct Point {
    std::uint64_t after, text;
};

constexpr Point point_after(int decimals) {
    const int place = 8 * (7 - decimals);
    return {~std::uint64_t{0} << 8 << place,
            0x3030303030303030 - (std::uint64_t{'0' - '.'} << place)};
}

constexpr Point kPoints[kMostDecimals + 1] = {point_after(0), point_after(1), point_after(2),
                                              point_after(3), point_after(4), point_after(5),
                                              point_after(6)};

// Stores all eight bytes of a word, the lowest one first: one instruction where that is the order
// in memory.
void store_word(char* out, std::uint64_t text) {
    for (int i = 0; i < 8; ++i)
        out[i] = static_cast<char>(text >> 8 * i);
}

// What most numbers of a picture are, in units: offsets of a path's points, and sines. A larger
// table would push too much else out of the nearest cache.
constexpr std::uint32_t kListedUnits = 1000;

// Their texts, with as many decimals: the first character in the lowest byte, in the highest one
// their number.
struct ListedTexts {
    std::uint64_t of[kMostDecimals + 1][kListedUnits] = {};

    constexpr ListedTexts() {
        for (int decimals = 0; decimals <= kMostDecimals; ++decimals)
            for (std::uint32_t units = 0; units < kListedUnits; ++units)
                of[decimals][units] = text_of(units, decimals);
    }

    static constexpr std::uint64_t text_of(std::uint32_t units, int decimals) {
        std::uint64_t text = 0, size = 0;
        const auto put_before = [&](std::uint32_t character) {
            text = text << 8 | character;
            ++size;
        };
        for (; decimals > 0 && units % 10 == 0; --decimals)
            units /= 10;
        const bool has_point = decimals > 0;
        for (; decimals > 0; --decimals, units /= 10)
            put_before('0' + units % 10);
        if (has_point) put_before('.');
        for (; units > 0 || size == 0; units /= 10)
            put_before('0' + units % 10);
        return text | size << 56;
    }
};

constexpr ListedTexts kListedTexts;

// For numbers of four digits, of which at most four are decimals.
char* write_four(char* out, std::uint32_t units, int decimals) {
    const std::uint64_t digits = kFourDigits.of[units];
    const int before = 4 - decimals;  // the point
    const std::uint64_t whole = ~(~std::uint64_t{0} << 8 * before);
    const std::uint64_t text = ((digits & whole) | (digits & ~whole) << 8) + 0x3030303030 -
                               (std::uint64_t{'0' - '.'} << 8 * before);
    store_word(out, text);
    const int last = 7 - (std::countl_zero(digits) >> 3);
    return out + (last < before ? before : last + 2);
}

// What nearly all other numbers are below.
constexpr std::uint64_t kShortUnits = 10'000'000;

// For numbers above 0. Makes the text in one word and cuts it out of that.
char* write_short(char* out, std::uint32_t units, int decimals) {
    const std::uint64_t digits =
        kFourDigits.of[units / 10000] | std::uint64_t{kFourDigits.of[units % 10000]} << 32;
    const Point& point = kPoints[decimals];
    std::uint64_t text = ((digits & point.after) | (digits & ~point.after) >> 8) + point.text;
    const int place = 7 - decimals;
    const int first = std::countr_zero(digits) >> 3, last = 7 - (std::countl_zero(digits) >> 3);
    const int start = std::min(first - 1, place), end = last > place ? last + 1 : place;
    text >>= 8 * start;
    store_word(out, text);
    return out + (end - start);
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
    const double rest = scaled - static_cast<double>(whole);  // exact, as is twice that
    return whole + static_cast<std::int64_t>(2 * rest);
}

char* write_units(char* out, std::int64_t units, int decimals) {
    *out = '-';
    out += units < 0;
    const auto magnitude = static_cast<std::uint64_t>(units < 0 ? -units : units);
    if (magnitude < kListedUnits) {
        const std::uint64_t text = kListedTexts.of[decimals][magnitude];
        store_word(out, text);
        return out + (text >> 56);
    }
    if (magnitude < 10'000 && decimals <= 4)
        return write_four(out, static_cast<std::uint32_t>(magnitude), decimals);
    if (magnitude >= kShortUnits) return write_long(out, magnitude, decimals);
    return write_short(out, static_cast<std::uint32_t>(magnitude), decimals);
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
