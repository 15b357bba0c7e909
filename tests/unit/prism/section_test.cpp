// SPDX-License-Identifier: MIT
#include "prism/section.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace edaha {
namespace {

void expect_near(Vec2 a, Vec2 b) {
    EXPECT_LT(glm::distance(a, b), 1e-12) << a.x << ',' << a.y << " and " << b.x << ',' << b.y;
}

TEST(Section, EquilateralHasItsAreaAndItsCentreInTheOrigin) {
    const Section section = equilateral(2);
    EXPECT_NEAR(area(section), 3 * std::sqrt(3.0), 1e-12);  // 3/4 sqrt 3 r^2
    expect_near(centroid(section), Vec2(0, 0));
    for (const Vec2& corner : section.corners)
        EXPECT_NEAR(glm::length(corner), 2, 1e-12);
}

TEST(Section, BySidesHasTheseSides) {
    const Section section = by_sides(5, 4, 3);
    const double sides[] = {5, 4, 3};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 side = section.corners[(i + 1) % 3] - section.corners[i];
        EXPECT_NEAR(glm::length(side), sides[i], 1e-12);
    }
    EXPECT_NEAR(area(section), 6, 1e-12);
    expect_near(centroid(section), Vec2(0, 0));
    EXPECT_EQ(longest_side(section), 0U);
    EXPECT_EQ(longest_side(by_sides(3, 4, 5)), 2U);
}

TEST(Section, HalvesOfARightTriangleCutThroughItsLongestSide) {
    const Section right{{Vec2(0, 0), Vec2(0, 3), Vec2(4, 0)}};  // from z to x
    ASSERT_NEAR(area(right), 6, 1e-12);
    ASSERT_EQ(longest_side(right), 1U);
    const Halves halves = halve(right, 1, 0.5);
    expect_near(halves.centre_a, Vec2(2, 4.5) / 3.0);
    expect_near(halves.centre_b, Vec2(6, 1.5) / 3.0);
    EXPECT_NEAR(area(halves.a), 3, 1e-12);
    EXPECT_NEAR(area(halves.b), 3, 1e-12);
}

TEST(Section, TheCutSharesOutTheAreaAsItDividesTheSide) {
    const Section whole = by_sides(7, 6, 4);
    for (const double at : {0.1, 0.35, 0.5, 0.8}) {
        const Halves halves = halve(whole, 0, at);
        EXPECT_NEAR(area(halves.a), at * area(whole), 1e-12);
        EXPECT_NEAR(area(halves.b), (1 - at) * area(whole), 1e-12);
    }
}

}  // namespace
}  // namespace edaha
