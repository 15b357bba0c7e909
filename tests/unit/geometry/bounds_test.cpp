// SPDX-License-Identifier: MIT
#include "geometry/bounds.h"

#include <gtest/gtest.h>

#include "geometry/bezier.h"
#include "shapes.h"

namespace edaha {
namespace {

TEST(Bounds, OfNothingAreEmpty) {
    const Bounds box = bounds(Path{});
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.width(), 0);
    EXPECT_EQ(box.height(), 0);
}

TEST(Bounds, IncludingAnEmptyBoxChangesNothing) {
    Bounds box;
    box.include(Vec2(1, 2));
    box.include(Bounds{});
    EXPECT_EQ(box.min, Vec2(1, 2));
    EXPECT_EQ(box.max, Vec2(1, 2));
}

TEST(Bounds, FollowTheCurveAndNotItsControlPoints) {
    Path path;
    path.move_to({0, 0});
    path.cubic_to({0, 4}, {10, 4}, {10, 0});  // rises to three quarters of its arms
    const Bounds box = bounds(path);
    EXPECT_DOUBLE_EQ(box.max.y, 3);
    EXPECT_EQ(box.min, Vec2(0, 0));
    EXPECT_EQ(box.max.x, 10);
}

TEST(Bounds, OfACubicHoldEverySampleTightly) {
    shapes::Random random;
    for (int round = 0; round < 200; ++round) {
        const auto point = [&] { return Vec2(random(), random()); };
        const Cubic c{point(), point(), point(), point()};
        Path path;
        path.move_to(c.p0);
        path.cubic_to(c.p1, c.p2, c.p3);
        const Bounds box = bounds(path);
        Bounds sampled;
        for (int i = 0; i <= 4000; ++i)
            sampled.include(eval(c, i / 4000.0));
        for (const int axis : {0, 1}) {
            EXPECT_LE(box.min[axis], sampled.min[axis] + 1e-12);
            EXPECT_GE(box.max[axis], sampled.max[axis] - 1e-12);
            EXPECT_NEAR(box.min[axis], sampled.min[axis], 1e-6);
            EXPECT_NEAR(box.max[axis], sampled.max[axis], 1e-6);
        }
    }
}

}  // namespace
}  // namespace edaha
