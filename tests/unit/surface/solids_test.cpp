// SPDX-License-Identifier: MIT
#include "surface/solids.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "unit/surface/solid_of.h"

namespace edaha {
namespace {

TEST(Solid, DistancesAreThoseOfItsShape) {
    const Solid plane(solid_of(SolidShape::plane, {0, 10, 0}, {0, 20, 0}, 0));
    EXPECT_DOUBLE_EQ(plane.distance({5, 13, 7}), 3);
    EXPECT_DOUBLE_EQ(plane.distance({5, 4, 7}), -6);
    const Solid box(solid_of(SolidShape::box, {4, 0, 0}, {0, 2, 6}, 0));
    EXPECT_DOUBLE_EQ(box.distance({7, 6, 3}), 5);
    EXPECT_DOUBLE_EQ(box.distance({2, 1, 3}), -1);
    EXPECT_DOUBLE_EQ(box.distance({2, 5, 3}), 3);
    const Solid ball(solid_of(SolidShape::ball, {1, 1, 1}, {}, 2));
    EXPECT_DOUBLE_EQ(ball.distance({1, 6, 1}), 3);
    EXPECT_DOUBLE_EQ(ball.distance({1, 1, 1}), -2);
    const Solid rod(solid_of(SolidShape::rod, {0, 0, 0}, {10, 0, 0}, 1));
    EXPECT_DOUBLE_EQ(rod.distance({5, 3, 4}), 4);
    EXPECT_DOUBLE_EQ(rod.distance({13, 4, 0}), 4);
    EXPECT_DOUBLE_EQ(rod.distance({5, 0, 0}), -1);
}

// No place on its middle line is further off than the zigzag is wide, and its corners are inside.
TEST(Solid, AWireIsARodInZigzag) {
    const SolidParams params = solid_of(SolidShape::wire, {0, 0, 0}, {800, 0, 0}, 10);
    const Solid wire(params);
    double most = 0;
    for (double x = 0; x <= 800; x += 5)
        most = std::max(most, wire.distance({x, 0, 0}));
    EXPECT_LT(most, 40);
    EXPECT_GT(most, 0);
    EXPECT_DOUBLE_EQ(
        wire.distance({0, -40, 0}) < 0 ? wire.distance({0, -40, 0}) : wire.distance({0, 40, 0}),
        -10);
}

TEST(Solid, OutwardIsTheWayFromTheNearestPlace) {
    const Solid ball(solid_of(SolidShape::ball, {1, 1, 1}, {}, 2));
    for (const Vec3 way : {Vec3(1, 0, 0), Vec3(0, 0.6, 0.8), Vec3(0, 0, -1)}) {
        EXPECT_NEAR(glm::distance(ball.outward(Vec3(1) + way * 5.0), way), 0, 1e-6);
        EXPECT_NEAR(glm::distance(ball.outward(Vec3(1) + way * 0.5), way), 0, 1e-6);
    }
}

TEST(Deepest, IsHowFarATriangleReachesIn) {
    const std::vector<Solid> rods{Solid(solid_of(SolidShape::rod, {0, 0, -500}, {0, 0, 500}, 30))};
    // Its corners are far outside, its middle passes through the rod 20 above its axis.
    const Vec3 a(-100, 20, -80), b(100, 20, -80), c(0, 20, 120);
    EXPECT_NEAR(deepest(rods, {a, b, c}, {1, 0, 0.05}), 10, 0.05);
    EXPECT_EQ(deepest(rods, {a, b, c}, {1, 12, 0.05}), 12);
    EXPECT_TRUE(is_deeper(rods, {a, b, c}, {1, 9.9, 0.01}));
    EXPECT_FALSE(is_deeper(rods, {a, b, c}, {1, 10.1, 0.01}));
    const Vec3 up(0, 40, 0);
    EXPECT_EQ(deepest(rods, {a + up, b + up, c + up}, {1, 0, 0.05}), 0);
    EXPECT_EQ(deepest(rods, {a, b, c}, {0, 0, 0.05}), 0);  // not there yet
    EXPECT_EQ(deepest({}, {a, b, c}, {1, 0, 0.05}), 0);
}

}  // namespace
}  // namespace edaha
