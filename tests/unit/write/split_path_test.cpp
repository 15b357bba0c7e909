// SPDX-License-Identifier: MIT
#include "write/split_path.h"

#include <gtest/gtest.h>

#include "drawing/subpaths.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

void add_square(Path& path, Vec2 corner, double side, bool hole) {
    const Vec2 right = corner + Vec2(side, 0), down = corner + Vec2(0, side);
    path.move_to(corner), path.line_to(hole ? down : right), path.line_to(corner + Vec2(side));
    path.line_to(hole ? right : down), path.close();
}

TEST(SplitPath, HolesStayWithTheirOutlines) {
    Path path;
    for (int i = 0; i < 30; ++i)
        add_square(path, {10.0 * i, 0}, 8, false);
    for (int i = 0; i < 30; ++i)
        add_square(path, {10.0 * i + 2, 2}, 4, true);
    const std::vector<Path> parts = split_path(path, 40);  // five frames of eight nodes
    EXPECT_EQ(parts.size(), 6u);
    for (const Path& part : parts) {
        EXPECT_LE(node_count(part), 40u);
        EXPECT_DOUBLE_EQ(signed_area(part), 5 * (64 - 16));
    }
}

// A frame around everything, islands in its hole, holes in the islands: the box of the frame holds
// every hole, but only its own goes with it.
TEST(SplitPath, AHoleBelongsToTheSmallestOutlineThatItLiesIn) {
    Path path;
    add_square(path, {0, 0}, 1000, false);
    add_square(path, {10, 10}, 980, true);
    for (int i = 0; i < 5; ++i)
        add_square(path, {100.0 + 100 * i, 100}, 50, false);
    for (int i = 0; i < 5; ++i)
        add_square(path, {110.0 + 100 * i, 110}, 30, true);
    const std::vector<Path> parts = split_path(path, 8);
    ASSERT_EQ(parts.size(), 6u);
    EXPECT_DOUBLE_EQ(signed_area(parts[0]), 1e6 - 980.0 * 980.0);
    for (int i = 1; i < 6; ++i)
        EXPECT_DOUBLE_EQ(signed_area(parts[i]), 2500 - 900);
}

// The box of a bent outline holds a hole that lies beside it.
TEST(SplitPath, AHoleInTheBoxButOutsideTheOutlineGoesElsewhere) {
    Path path;
    add_square(path, {0, 0}, 100, false);                                    // holds the hole
    path.move_to({20, 20}), path.line_to({70, 20}), path.line_to({70, 30});  // an angle around it
    path.line_to({30, 30}), path.line_to({30, 70}), path.line_to({20, 70}), path.close();
    add_square(path, {40, 40}, 10, true);
    const std::vector<Path> parts = split_path(path, 8);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_DOUBLE_EQ(signed_area(parts[0]), 10000 - 100);
}

TEST(SplitPath, ASubpathAboveTheLimitStaysWhole) {
    Path path;
    path.move_to({0, 0});
    for (int i = 1; i < 100; ++i)
        path.line_to({1.0 * i, i % 2 * 1.0});
    const std::vector<Path> parts = split_path(path, 50);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].points, path.points);
}

}  // namespace
}  // namespace edaha
