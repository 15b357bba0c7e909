// SPDX-License-Identifier: MIT
#include "proproot/root_line.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace edaha::test {
namespace {

PropRoots plant(RootType type, std::uint64_t seed) {
    PropRootParams params;
    params.primaries = 49;
    params.type = type;
    return grow_prop_roots(params, KeyedRandom(1, seed, 1));
}

TEST(RootLine, RunsFromTheBaseToTheEnd) {
    for (const PropRoot& root : plant(RootType::standard, 1).roots) {
        const std::vector<LinePoint> line = root_line(root, {});
        ASSERT_GE(line.size(), 2U);
        EXPECT_EQ(line.back().along, root.length);
        EXPECT_EQ(line.front().along < 0, root.order == 1);
        for (std::size_t i = 1; i < line.size(); ++i)
            EXPECT_LT(line[i - 1].along, line[i].along);
    }
}

TEST(RootLine, FollowsTheCatenaryClosely) {
    for (const PropRoot& root : plant(RootType::standard, 2).roots) {
        const std::vector<LinePoint> line = root_line(root, {});
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (line[i - 1].along < 0) continue;
            const double middle = (line[i - 1].along + line[i].along) / 2;
            const Vec3 chord = (line[i - 1].position + line[i].position) / 2.0;
            EXPECT_LT(glm::distance(root.at(middle), chord), 0.5 * root.radius);
        }
    }
}

// A tenth more at the ground than at the branching point, away from knob and tip.
TEST(RootLine, ThickensOutward) {
    PropRoot root;
    root.curve = {-200, 60, 0};
    root.base = {0, 60, 0};
    root.length = root.curve.length(root.curve.at_height(0));
    root.radius = 4;
    EXPECT_DOUBLE_EQ(root_line(root, {}).front().radius, 4);
    EXPECT_DOUBLE_EQ(root_line(root, {}).back().radius, 4.4);
    root.trunk_radius = 8;
    PropRootParams params;
    params.knob = 0.5;
    const std::vector<LinePoint> knobbed = root_line(root, params);
    EXPECT_DOUBLE_EQ(knobbed.front().radius, 6);
    EXPECT_DOUBLE_EQ(knobbed.back().radius, 4.4);
    for (const LinePoint& point : knobbed)
        EXPECT_LE(point.radius, 6.01);
    root.young = true;
    EXPECT_EQ(root_line(root, params).back().radius, 0);
}

TEST(RootLine, MoreCurvePointsMakeFinerLines) {
    const PropRoots roots = plant(RootType::standard, 3);
    std::size_t coarse = 0, fine = 0;
    PropRootParams few, many;
    few.curve_points = 8;
    many.curve_points = 64;
    for (const PropRoot& root : roots.roots) {
        coarse += root_line(root, few).size();
        fine += root_line(root, many).size();
    }
    EXPECT_GT(fine, 3 * coarse);
}

}  // namespace
}  // namespace edaha::test
