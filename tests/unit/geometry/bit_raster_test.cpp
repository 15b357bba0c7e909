// SPDX-License-Identifier: MIT
#include "geometry/bit_raster.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/measure.h"
#include "shapes.h"

namespace edaha {
namespace {

const Affine kSame(1, 0, 0, 1, 0, 0);

TEST(BitRaster, SetsTheSamplesInsideABox) {
    BitRaster raster(200, 10);
    EXPECT_EQ(raster.fill(shapes::box(3.4, 2.6, 130.6, 7.4), kSame), 128 * 4);
    for (int row = 0; row < raster.rows(); ++row) {
        for (int column = 0; column < raster.columns(); ++column) {
            const bool inside = column >= 3 && column <= 130 && row >= 3 && row <= 6;
            ASSERT_EQ(raster.at(column, row), inside) << column << ' ' << row;
        }
    }
    EXPECT_EQ(raster.count(), 128 * 4);
}

TEST(BitRaster, CountsWhatIsCoveredAgain) {
    BitRaster raster(100, 100);
    EXPECT_EQ(raster.fill(shapes::box(0, 0, 60, 100), kSame), 6000);
    EXPECT_EQ(raster.fill(shapes::box(40, 0, 100, 100), kSame), 6000);
    EXPECT_EQ(raster.count(), 10000);
}

TEST(BitRaster, LeavesOutHolesAndWhatLiesOutside) {
    BitRaster raster(64, 64);
    Path ring = shapes::box(-1000, 10, 1000, 50);
    shapes::append(ring, reversed(shapes::box(20, 20, 30, 30)));
    EXPECT_EQ(raster.fill(ring, kSame), 64 * 40 - 100);
    EXPECT_FALSE(raster.at(25, 25));
    EXPECT_EQ(raster.fill(shapes::box(70, 0, 90, 64), kSame), 0);
    EXPECT_EQ(raster.fill(shapes::box(0, -9, 64, 0), kSame), 0);
}

// The same region twice over, and an open subpath: closed by a straight way back.
TEST(BitRaster, FillsByTheNonZeroRule) {
    Path twice = shapes::box(10, 10, 20, 20);
    shapes::append(twice, twice);
    twice.move_to({30, 10});
    twice.line_to({40, 10});
    twice.line_to({40, 20});
    twice.line_to({30, 20});
    BitRaster raster(64, 64);
    EXPECT_EQ(raster.fill(twice, kSame), 200);
}

TEST(BitRaster, NeighboursShareNoSampleAndLeaveNone) {
    BitRaster raster(50, 50);
    const Path above = shapes::polygon({{0, 0}, {50, 0}, {50, 31}, {0, 7}});
    const Path below = shapes::polygon({{0, 7}, {50, 31}, {50, 50}, {0, 50}});
    const std::int64_t sum = raster.fill(above, kSame) + raster.fill(below, kSame);
    EXPECT_EQ(sum, 2500);
    EXPECT_EQ(raster.count(), 2500);
}

TEST(BitRaster, CountsTheAreaOfACircle) {
    BitRaster raster(1000, 1000);
    const auto count = static_cast<double>(raster.fill(shapes::circle({500, 500}, 400), kSame));
    // Circles of radius r hold pi r^2 lattice points, give or take a few times r^(2/3).
    EXPECT_NEAR(count, 160000 * shapes::kPi, 300);
}

TEST(BitStamp, IsTheShapeUnderAnyMap) {
    const Path leaf = shapes::circle({64, 64}, 60);
    BitRaster shape(128, 128);
    shape.fill(leaf, kSame);
    const BitStamp stamp(shape);
    for (const double angle : {0.0, 0.4, 1.5707963267948966, 2.5, -2.0}) {
        const double c = std::cos(angle), s = std::sin(angle);
        // Twice as long as wide, turned: an ellipse that no box of the stamp is parallel to.
        const Affine map(Vec2(c, s) * 1.5, Vec2(-s, c) * 0.75, Vec2(200.3, 190.7));
        BitRaster drawn(400, 400), stamped(400, 400);
        const std::int64_t covered = drawn.fill(leaf, map);
        EXPECT_NEAR(static_cast<double>(stamp.set_on(stamped, map)), static_cast<double>(covered),
                    0.01 * static_cast<double>(covered));
        int different = 0;
        for (int row = 0; row < 400; ++row) {
            for (int column = 0; column < 400; ++column)
                different += drawn.at(column, row) != stamped.at(column, row);
        }
        EXPECT_LT(different, 0.02 * static_cast<double>(covered)) << angle;
        EXPECT_EQ(stamped.count(), stamp.set_on(stamped, map));
    }
}

TEST(BitStamp, StaysOnTheRaster) {
    BitRaster shape(8, 8);
    shape.fill(shapes::box(0, 0, 8, 8), kSame);
    const BitStamp stamp(shape);
    BitRaster raster(70, 70);
    EXPECT_EQ(stamp.set_on(raster, Affine(100, 0, 0, 100, -50, -50)), 70 * 70);
    for (const Vec2 away : {Vec2(-9, 3), Vec2(71, 3), Vec2(3, -9), Vec2(3, 71), Vec2(-1e9, 1e9)})
        EXPECT_EQ(stamp.set_on(raster, Affine(1, 0, 0, 1, away.x, away.y)), 0);
    EXPECT_EQ(stamp.set_on(raster, Affine(1e-9, 0, 0, 1e-9, 9.5, 9.5)), 0);
    EXPECT_EQ(stamp.set_on(raster, Affine(1, 1, 2, 2, 9, 9)), 0);
}

}  // namespace
}  // namespace edaha
