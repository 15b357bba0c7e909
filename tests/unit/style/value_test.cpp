// SPDX-License-Identifier: MIT
#include "style/value.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

// What `text` leaves in the parameter, or what is wrong with it.
std::string after(const char* key, const std::string& text) {
    const Parameter* const parameter = find_parameter(key);
    if (parameter == nullptr) return "no such parameter";
    Style style;
    const auto wrong = assign(style, *parameter, text);
    if (!wrong) return value_text(style, *parameter);
    EXPECT_EQ(value_text(style, *parameter), value_text(Style(), *parameter));
    return *wrong;
}

TEST(Value, Numbers) {
    EXPECT_EQ(after("growth.energy", "800"), "800");
    EXPECT_EQ(after("growth.energy", " 8e2\n"), "800");
    EXPECT_EQ(after("growth.energy", "1e6"), "1e6");
    EXPECT_EQ(after("growth.energy", "abc"), "'abc' is not a number (expected 1 … 1e6)");
    EXPECT_EQ(after("growth.energy", ""), "'' is not a number (expected 1 … 1e6)");
    EXPECT_EQ(after("growth.energy", "nan"), "'nan' is not a number (expected 1 … 1e6)");
    EXPECT_EQ(after("growth.energy", "0.99"), "'0.99' is out of range (expected 1 … 1e6)");
    EXPECT_EQ(after("page.margin", "-1"), "'-1' is out of range (expected 0 … 1000 mm)");
}

TEST(Value, WholeNumbers) {
    EXPECT_EQ(after("space.candidates", "8"), "8");
    EXPECT_EQ(after("variant.seed", "9007199254740991"), "9007199254740991");
    EXPECT_EQ(after("space.candidates", "2.5"), "'2.5' is not a whole number (expected 1 … 256)");
    EXPECT_EQ(after("space.candidates", "0"), "'0' is out of range (expected 1 … 256)");
    EXPECT_EQ(after("variant.seed", "9007199254740992"),
              "'9007199254740992' is out of range (expected 0 … 9007199254740991)");
}

TEST(Value, DegreesAreStoredAsRadians) {
    Style style;
    ASSERT_EQ(assign(style, *find_parameter("leaf.fan"), "30"), std::nullopt);
    EXPECT_DOUBLE_EQ(style.leaf.fan_rad, std::numbers::pi / 6);
    EXPECT_EQ(after("leaf.fan", "181"), "'181' is out of range (expected 0 … 180 degrees)");
}

TEST(Value, RangesAndLists) {
    EXPECT_EQ(after("branch.turn", "-30 40.5"), "-30 40.5");
    EXPECT_EQ(after("branch.turn", "-30..40.5"), "-30 40.5");
    EXPECT_EQ(after("growth.share", ".2 .. .4"), "0.2 0.4");
    EXPECT_EQ(after("growth.share", "0.5"), "0.5");
    EXPECT_EQ(after("growth.share", "0.4 0.2"),
              "'0.4 0.2' is a reversed range (expected low high, each 0.01 … 0.99)");
    EXPECT_EQ(after("growth.share", "0.1 0.2 0.3"),
              "'0.1 0.2 0.3' is not a range (expected low high, each 0.01 … 0.99)");
    EXPECT_EQ(after("growth.share", "..0.2"),
              "'..0.2' is not a range (expected low high, each 0.01 … 0.99)");
    EXPECT_EQ(after("space.habit", "0 20  45"), "0 20 45");
    EXPECT_EQ(after("space.habit", "0,20"),
              "'0,20' is not a list of numbers (expected 1 to 32 numbers, each 0 … 180 degrees)");
    EXPECT_EQ(after("space.habit", "0 200"),
              "'0 200' is out of range (expected 1 to 32 numbers, each 0 … 180 degrees)");
}

TEST(Value, NamesFlagsAndColours) {
    EXPECT_EQ(after("growth.type", "B"), "B");
    EXPECT_EQ(after("look.wood", "soild"),
              "'soild' is not known (expected solid, silhouette, outline or line; did you mean "
              "'solid'?)");
    EXPECT_EQ(after("growth.type", "three"), "'three' is not known (expected A or B)");
    EXPECT_EQ(after("look.straight", "yes"), "yes");
    EXPECT_EQ(after("look.straight", "true"), "'true' is neither (expected yes or no)");
    EXPECT_EQ(after("palette.leaf", "#1fA0c3"), "#1fa0c3");
    EXPECT_EQ(after("palette.leaf", "green"), "'green' is not a colour (expected #rrggbb)");
    EXPECT_EQ(after("palette.leaf", "#12345g"), "'#12345g' is not a colour (expected #rrggbb)");
}

TEST(Value, MessagesShowLittleOfALongText) {
    EXPECT_EQ(in_quotes("a\n\x1b[31m"), "'a??[31m'");
    EXPECT_EQ(in_quotes(std::string(41, 'a')), "'" + std::string(40, 'a') + "…'");
    std::string leaves;
    for (int i = 0; i < 40; ++i)
        leaves += "葉";
    EXPECT_EQ(in_quotes(leaves), "'" + leaves + "'");
}

TEST(Value, ShortestText) {
    EXPECT_EQ(shortest_text(0.1), "0.1");
    EXPECT_EQ(shortest_text(-0.0), "0");
    EXPECT_EQ(shortest_text(100000), "100000");
    EXPECT_EQ(shortest_text(-1e6), "-1e6");
    EXPECT_EQ(shortest_text(1234567), "1234567");
    EXPECT_EQ(shortest_text(0.001), "0.001");
    EXPECT_EQ(shortest_text(1e-7), "1e-7");
    EXPECT_EQ(shortest_text(1.5e300), "1.5e300");
}

TEST(Value, DegreesOfPlainNumbersStayPlain) {
    for (int tenths = -1800; tenths <= 1800; ++tenths) {
        const double angle = tenths / 10.0;
        Style style;
        style.energy.branch.turn_rad = {radians(angle), radians(angle)};
        EXPECT_EQ(value_text(style, *find_parameter("branch.turn")), shortest_text(angle));
    }
}

}  // namespace
}  // namespace edaha
