// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace edaha {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NumberText, IsAsShortAsItsDecimalsAllow) {
    EXPECT_EQ(number_text(0.5, 2), ".5");
    EXPECT_EQ(number_text(-0.5, 2), "-.5");
    EXPECT_EQ(number_text(3.0, 6), "3");
    EXPECT_EQ(number_text(-3.10, 2), "-3.1");
    EXPECT_EQ(number_text(0.05, 3), ".05");
    EXPECT_EQ(number_text(1200, 0), "1200");
    EXPECT_EQ(number_text(100.001, 3), "100.001");
    EXPECT_EQ(number_text(0.000001, 6), ".000001");
}

TEST(NumberText, NothingIsNegativeZero) {
    EXPECT_EQ(number_text(-0.0, 2), "0");
    EXPECT_EQ(number_text(-0.004, 2), "0");
    EXPECT_EQ(number_text(0, 0), "0");
}

TEST(NumberText, HalvesGoAwayFromZero) {
    EXPECT_EQ(number_text(0.5, 0), "1");
    EXPECT_EQ(number_text(-0.5, 0), "-1");
    EXPECT_EQ(number_text(1.125, 2), "1.13");
    EXPECT_EQ(number_text(2.675, 2), "2.68");
    EXPECT_EQ(number_text(0.49999999999999994, 0), "0");  // adding 0.5 first would make it 1
    EXPECT_EQ(number_text(9.999, 2), "10");
}

TEST(NumberText, BrokenAndHugeNumbersStayWellFormed) {
    EXPECT_EQ(number_text(std::nan(""), 2), "0");
    EXPECT_EQ(number_text(kInfinity, 0), "9007199254740992");
    EXPECT_EQ(number_text(-1e300, 0), "-9007199254740992");
    EXPECT_EQ(number_text(4503599627370497.0, 0), "4503599627370497");
    EXPECT_EQ(number_text(4294967296.25, 2), "4294967296.25");
}

// The C library's reader is the oracle: what is written is read back to within half a unit, and no
// shorter text of that many decimals is.
TEST(NumberText, IsReadBackToWithinHalfAUnit) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 200000; ++i) {
        const int decimals = static_cast<int>(random() % (kMostDecimals + 1));
        const double unit = std::pow(10.0, -decimals);
        const double range = std::pow(10.0, static_cast<double>(random() % 7));
        const double value = range * (static_cast<double>(random() >> 11) / 4503599627370496.0 - 1);
        const std::string text = number_text(value, decimals);
        const double back = std::strtod(text.c_str(), nullptr);
        ASSERT_LE(std::abs(back - value), unit * 0.5000001) << text << " for " << value;
        const bool has_point = text.find('.') != std::string::npos;
        ASSERT_FALSE(has_point && (text.back() == '0' || text.back() == '.')) << text;
        ASSERT_LT(text.size(), static_cast<std::size_t>(kLongestNumber));
    }
}

// Every small number, by the C library: all its decimals, then without the zeros that say nothing.
TEST(NumberText, SmallUnitsToTheLetter) {
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
        for (int units = -20'000; units <= 20'000; ++units) {
            char full[32];
            std::snprintf(full, sizeof full, "%.*f", decimals, units / std::pow(10.0, decimals));
            std::string expected = full;
            if (decimals > 0) expected.erase(expected.find_last_not_of('0') + 1);
            if (expected.back() == '.') expected.pop_back();
            const std::size_t digit = expected.find_first_of("0123456789");
            if (expected[digit] == '0' && expected.size() > digit + 1) expected.erase(digit, 1);
            char text[kLongestNumber];
            ASSERT_EQ(std::string(text, write_units(text, units, decimals)), expected);
        }
    }
}

TEST(ParseNumber, ReadsTheWholeText) {
    EXPECT_EQ(parse_number("12.5"), 12.5);
    EXPECT_EQ(parse_number("-.5"), -0.5);
    EXPECT_EQ(parse_number("+3"), 3.0);
    EXPECT_EQ(parse_number("1e6"), 1e6);
    EXPECT_EQ(parse_number("2.E-3"), 2e-3);
}

TEST(ParseNumber, RefusesEverythingElse) {
    for (const char* text : {"", " 1", "1 ", "1,5", "abc", "nan", "inf", "-infinity", "0x10",
                             "1e999", "+", "-", "+-1", "++1", "--1", "1e", ".", "1mm"}) {
        EXPECT_EQ(parse_number(text), std::nullopt) << text;
    }
}

}  // namespace
}  // namespace edaha
