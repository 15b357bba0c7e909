// SPDX-License-Identifier: MIT
#include "drawing/statistics.h"

#include <gtest/gtest.h>

#include "drawing/subpaths.h"

namespace edaha {
namespace {

Path triangle(double x) {
    Path path;
    path.move_to({x, 1}), path.line_to({x + 1, 1}), path.line_to({x + 1, 2}), path.close();
    return path;
}

TEST(Statistics, CountsSymbolsNodesOnceAndNestedOnesAll) {
    Drawing drawing;
    drawing.symbols = {{"leaf", {{"", triangle(0), {}}}}};
    Group group{"g", {}, {Shape{"", triangle(1), {}}, Use{}, Use{}}};
    drawing.layers = {{"Wood", {}, {Shape{"", triangle(2), {}}, group}}, {"Leaves", {}, {Use{}}}};
    const DrawingCounts counts = count(drawing);
    EXPECT_EQ(counts.layers, 2u);
    EXPECT_EQ(counts.groups, 1u);
    EXPECT_EQ(counts.symbols, 1u);
    EXPECT_EQ(counts.shapes, 2u);
    EXPECT_EQ(counts.uses, 3u);
    EXPECT_EQ(counts.nodes, 9u);
}

TEST(Subpaths, AreThePathCutAtItsMoves) {
    Path both = triangle(1);
    both.move_to({5, 5}), both.cubic_to({6, 5}, {7, 6}, {7, 7});
    const std::vector<Path> parts = subpaths(both);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].verbs, triangle(1).verbs);
    EXPECT_EQ(parts[0].points, triangle(1).points);
    EXPECT_EQ(parts[1].points.size(), 4u);
    EXPECT_EQ(node_count(both), 5u);
    EXPECT_TRUE(subpaths({}).empty());
}

}  // namespace
}  // namespace edaha
