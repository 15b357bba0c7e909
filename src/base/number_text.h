// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace edaha {

// Decimal text of numbers, as short as the number of decimals allows: no trailing zeros, no zero
// before the point, never "-0": 0.50 is ".5", -3.0 is "-3". Locale-free; the same on any machine.
//
// Rounding: value x 10^decimals is taken as a double, then rounded to the nearest whole unit,
// halves away from zero. So 2.675 with two decimals is 2.68, although the double lies just below
// it.
inline constexpr int kMostDecimals = 6;

// The longest text that write_units makes: sign, 16 digits, point, with room to spare.
inline constexpr int kLongestNumber = 24;

// `value` in units of 10^-decimals, decimals 0 to kMostDecimals. Beyond 2^53 units it stays at that
// bound; NaN is 0: the text of a broken number is still well-formed.
std::int64_t to_units(double value, int decimals);

// Writes the number at `out`, which has room for kLongestNumber, and returns the end. About 5 ns.
char* write_units(char* out, std::int64_t units, int decimals);

void append_number(std::string& text, double value, int decimals);
std::string number_text(double value, int decimals);

// The whole of `text` as a finite number: digits, point, exponent, one sign. Nothing for "", "1 ",
// "nan", "0x10", "1e999".
std::optional<double> parse_number(std::string_view text);

}  // namespace edaha
