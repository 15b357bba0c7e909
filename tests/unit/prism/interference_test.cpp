// SPDX-License-Identifier: MIT
#include "prism/interference.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

PrismCorners upright(Vec3 origin, double radius = 1, double length = 4) {
    Prism prism;
    prism.base = equilateral(radius);
    prism.origin = origin;
    prism.length = length;
    return open_corners(prism);
}

TEST(Interference, EqualPrismsOverlap) {
    const PrismCorners prism = upright(Vec3(3, 5, 7));
    EXPECT_TRUE(overlap(prism, prism));
}

TEST(Interference, PrismsThatOnlyTouchDoNot) {
    const PrismCorners prism = upright(Vec3(0));
    EXPECT_FALSE(overlap(prism, upright(Vec3(0, 4, 0))));     // one on top of the other
    EXPECT_TRUE(overlap(prism, upright(Vec3(0, 3.99, 0))));   // shifted along their own sides
    EXPECT_FALSE(overlap(prism, upright(Vec3(0, 1, -1.5))));  // corner to side
    EXPECT_TRUE(overlap(prism, upright(Vec3(0, 1, -1.49))));
}

TEST(Interference, OneInsideTheOtherOverlaps) {
    const PrismCorners outer = upright(Vec3(0)), inner = upright(Vec3(0, 1, 0), 0.1, 1);
    EXPECT_TRUE(overlap(outer, inner));
    EXPECT_TRUE(overlap(inner, outer));
}

TEST(Interference, PyramidsEndAtTheirPoint) {
    Prism prism;
    prism.base = equilateral(1);
    prism.length = 4;
    prism.top = 0;
    const PrismCorners pyramid = open_corners(prism);
    EXPECT_FALSE(overlap(pyramid, upright(Vec3(0.9, 3, 0), 0.5, 1)));
    EXPECT_TRUE(overlap(pyramid, upright(Vec3(0, 3.9, 0), 0.5, 1)));
    EXPECT_FALSE(overlap(pyramid, upright(Vec3(0, 4, 0), 0.5, 1)));
}

TEST(Interference, ParentAndSiblingsAreNotInTheWay) {
    StandingPrisms standing;
    standing.add(upright(Vec3(0)), -1);
    standing.add(upright(Vec3(0, 4, 0)), 0);
    EXPECT_FALSE(standing.in_the_way(upright(Vec3(0, 3.5, 0)), 0));
    EXPECT_TRUE(standing.in_the_way(upright(Vec3(0, 3.5, 0)), 1));  // the first is its grandparent
    EXPECT_FALSE(standing.in_the_way(upright(Vec3(0, 8, 0)), 1));
}

TEST(Interference, PrismsOfAllSizesAreFound) {
    for (const double size : {1e-3, 0.3, 20.0, 1e4}) {
        StandingPrisms standing;
        for (int i = 0; i < 50; ++i)
            standing.add(upright(Vec3(i * 3 * size, 0, 0), size, 4 * size), -1);
        for (int i = 0; i < 50; ++i) {
            const Vec3 place(i * 3 * size, 2 * size, 0);
            EXPECT_TRUE(standing.in_the_way(upright(place, 1, 4), 99)) << size;
            EXPECT_FALSE(standing.in_the_way(upright(place + Vec3(0, 0, 3 * size + 3), 1, 4), 99));
        }
    }
}

}  // namespace
}  // namespace edaha
