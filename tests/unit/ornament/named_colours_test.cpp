// SPDX-License-Identifier: MIT
#include "ornament/named_colours.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace edaha {
namespace {

TEST(NamedColours, ThereAre147InOrder) {
    const auto names = colour_names();
    EXPECT_EQ(names.size(), 147U);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const std::string& name : names)
        EXPECT_TRUE(named_colour(name)) << name;
}

TEST(NamedColours, SomeValuesOfTheTable) {
    EXPECT_EQ(named_colour("black"), (Colour{0, 0, 0}));
    EXPECT_EQ(named_colour("YellowGreen"), (Colour{154, 205, 50}));
    EXPECT_EQ(named_colour("lightgoldenrodyellow"), (Colour{250, 250, 210}));
    EXPECT_EQ(named_colour("gray"), (Colour{128, 128, 128}));
    EXPECT_EQ(named_colour("green"), (Colour{0, 128, 0}));
    EXPECT_EQ(named_colour("grean"), std::nullopt);
    EXPECT_EQ(named_colour(""), std::nullopt);
}

// "gray" and "grey" are one; the pure colours of both vocabularies agree.
TEST(NamedColours, SynonymsAgree) {
    for (const std::string& name : colour_names()) {
        const std::size_t at = name.find("grey");
        if (at == std::string::npos) continue;
        std::string other = name;
        other[at + 2] = 'a';
        EXPECT_EQ(named_colour(name), named_colour(other)) << name;
    }
    EXPECT_EQ(named_colour("aqua"), named_colour("cyan"));
    EXPECT_EQ(named_colour("fuchsia"), named_colour("magenta"));
}

}  // namespace
}  // namespace edaha
