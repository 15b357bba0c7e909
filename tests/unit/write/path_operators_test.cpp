// SPDX-License-Identifier: MIT
#include "write/path_operators.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

std::string operators_of(const Path& path, int decimals) {
    std::string text;
    append_path_operators(text, path, decimals);
    return text;
}

TEST(PathOperators, EachVerbHasItsOwn) {
    Path path;
    path.move_to({1, 2});
    path.line_to({3.25, 2});
    path.cubic_to({4, 3}, {5, 4}, {6, 4});
    path.close();
    EXPECT_EQ(operators_of(path, 2), "1 2 m\n3.25 2 l\n4 3 5 4 6 4 c\nh\n");
}

TEST(PathOperators, ControlPointsAtTheEndsAreLeftOut) {
    Path path;
    path.move_to({1, 2});
    path.cubic_to({1, 2}, {5, 4}, {6, 4});
    path.cubic_to({7, 4}, {9, 6}, {9, 6});
    path.cubic_to({9, 6}, {8, 0}, {8, 0});  // a line
    EXPECT_EQ(operators_of(path, 1), "1 2 m\n5 4 6 4 v\n7 4 9 6 y\n8 0 l\n");
}

TEST(PathOperators, WhatRoundsToNothingIsLeftOut) {
    Path path;
    path.move_to({1, 2});
    path.line_to({1.04, 2.04});
    path.close();
    EXPECT_EQ(operators_of(path, 1), "");
    EXPECT_EQ(operators_of(path, 2), "1 2 m\n1.04 2.04 l\nh\n");
    path.move_to({5, 5});
    path.cubic_to({5.01, 5}, {5.02, 5}, {5.03, 5});
    path.line_to({7, 5});
    EXPECT_EQ(operators_of(path, 1), "5 5 m\n7 5 l\n");
    std::string text;
    EXPECT_FALSE(append_path_operators(text, {}, 1));
}

TEST(PathOperators, MapsHaveTheirDecimals) {
    std::string text;
    append_map_operator(text, Affine(0.12345, 0, -0.5, 1, 3.14159, -2), 3, 1);
    EXPECT_EQ(text, ".123 0 -.5 1 3.1 -2 cm\n");
}

TEST(PathOperators, DashesThatRoundToNothingAreNone) {
    std::string text;
    for (const double mm : {1.25, 0.0, 0.004})
        append_dash_operator(text, mm, 1);
    EXPECT_EQ(text, "[1.25] 0 d\n[] 0 d\n[] 0 d\n");
}

}  // namespace
}  // namespace edaha
