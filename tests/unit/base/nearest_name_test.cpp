// SPDX-License-Identifier: MIT
#include "base/nearest_name.h"

#include <vector>

#include <gtest/gtest.h>

namespace edaha {
namespace {

const std::vector<std::string> kNames = {"circle", "ellipse", "line", "rect"};

TEST(NearestName, OneSlipIsForgiven) {
    EXPECT_EQ(nearest_name("circel", kNames), "circle");     // swapped
    EXPECT_EQ(nearest_name("ellipsee", kNames), "ellipse");  // one too many
    EXPECT_EQ(nearest_name("lin", kNames), "line");          // one too few
    EXPECT_EQ(nearest_name("rekt", kNames), "rect");         // another
    EXPECT_EQ(nearest_name("RECT", kNames), "rect");
}

TEST(NearestName, AThirdOfTheLettersMayBeWrong) {
    EXPECT_EQ(nearest_name("elipze", kNames), "ellipse");
    EXPECT_EQ(nearest_name("elipzz", kNames), std::nullopt);
    EXPECT_EQ(nearest_name("re", kNames), std::nullopt);
    EXPECT_EQ(nearest_name("", kNames), std::nullopt);
    EXPECT_EQ(nearest_name("rect", {}), std::nullopt);
}

TEST(NearestName, TheFirstOfEqualsWins) {
    const std::vector<std::string> names = {"cat", "car", "cab"};
    EXPECT_EQ(nearest_name("cap", names), "cat");
}

}  // namespace
}  // namespace edaha
