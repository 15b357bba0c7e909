// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>

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

// The two digits of 0 to 99, and with how many zeros they end.
struct DigitPairs {
    char text[100][2] = {};
    std::uint8_t zeros[100] = {};

    constexpr DigitPairs() {
        for (unsigned i = 0; i < 100; ++i) {
            text[i][0] = static_cast<char>('0' + i / 10);
            text[i][1] = static_cast<char>('0' + i % 10);
            zeros[i] = i == 0 ? 2 : i % 10 == 0;
        }
    }
};

constexpr DigitPairs kPairs;

char* write_pair(char* out, std::uint32_t number) {
    std::memcpy(out, kPairs.text[number], 2);
    return out + 2;
}

// Below 10000, without leading zeros.
char* write_whole(char* out, std::uint32_t number) {
    if (number >= 1000) return write_pair(write_pair(out, number / 100), number % 100);
    if (number >= 100) {
        *out = static_cast<char>('0' + number / 100);
        return write_pair(out + 1, number % 100);
    }
    if (number >= 10) return write_pair(out, number);
    *out = static_cast<char>('0' + number);
    return out + 1;
}

struct Halves {
    std::uint32_t whole, rest;  // the rest in units of 10^-4
};

// A case each, so that every divisor is known to the compiler.
Halves halves(std::uint32_t magnitude, int decimals) {
    switch (decimals) {
        case 0:
            return {magnitude, 0};
        case 1:
            return {magnitude / 10, magnitude % 10 * 1000};
        case 2:
            return {magnitude / 100, magnitude % 100 * 100};
        case 3:
            return {magnitude / 1000, magnitude % 1000 * 10};
        default:
            return {magnitude / 10000, magnitude % 10000};
    }
}

// What nearly all numbers of a picture are: at most four decimals, and four digits before them.
char* write_small(char* out, Halves number) {
    if (number.whole != 0 || number.rest == 0) out = write_whole(out, number.whole);
    if (number.rest == 0) return out;
    const std::uint32_t high = number.rest / 100, low = number.rest % 100;
    *out = '.';
    write_pair(write_pair(out + 1, high), low);
    return out + 5 - (low != 0 ? kPairs.zeros[low] : 2 + kPairs.zeros[high]);
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
    if (decimals <= 4 && magnitude <= 0xffffffff) {
        const Halves number = halves(static_cast<std::uint32_t>(magnitude), decimals);
        if (number.whole < 10000) return write_small(out, number);
    }
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
