// SPDX-License-Identifier: MIT
#include "energy/outline.h"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "energy/grow.h"
#include "energy/wood.h"
#include "geometry/bezier.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

struct Tree {
    LookParams look;
    Limbs limbs;
    std::vector<Path> outlines;
};

Tree tree_of(std::uint64_t seed) {
    EnergyParams params;
    params.variant.seed = seed;
    params.growth.energy = 200;
    params.space.candidates = 4;
    Tree tree;
    tree.limbs = make_limbs(grow(params), params, tree.look);
    for (const Limb& limb : tree.limbs.limbs)
        tree.outlines.push_back(outline(tree.limbs, limb, tree.look));
    return tree;
}

std::vector<Vec2> polygon(const Path& path) {
    std::vector<Vec2> points;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        if (verb == Verb::cubic) {
            const Cubic cubic{points.back(), path.points[at], path.points[at + 1],
                              path.points[at + 2]};
            for (int i = 1; i <= 12; ++i)
                points.push_back(eval(cubic, i / 12.0));
            at += 3;
        } else if (verb != Verb::close) {
            points.push_back(path.points[at++]);
        }
    }
    return points;
}

int winding(const std::vector<Vec2>& polygon, Vec2 p);

// Whether the limb or one that bears it covers a point.
bool covered(const Tree& tree, std::size_t limb, Vec2 p) {
    for (auto i = static_cast<std::int32_t>(limb); i >= 0;
         i = tree.limbs.limbs[static_cast<std::size_t>(i)].parent) {
        if (winding(polygon(tree.outlines[static_cast<std::size_t>(i)]), p) != 0) return true;
    }
    return false;
}

int winding(const std::vector<Vec2>& polygon, Vec2 p) {
    int turns = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        if (a.y <= p.y && b.y > p.y && side > 0) ++turns;
        if (a.y > p.y && b.y <= p.y && side < 0) --turns;
    }
    return turns;
}

}  // namespace

TEST(Outline, IsClosedFiniteAndPositive) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        for (const Path& path : tree_of(seed).outlines) {
            ASSERT_FALSE(path.empty());
            EXPECT_EQ(path.verbs.back(), Verb::close);
            EXPECT_GT(signed_area(path), 0);
            for (const Vec2 p : path.points)
                EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
        }
    }
}

// But for where a child still runs within its parent.
TEST(Outline, HoldsTheLimbsCentreLine) {
    const Tree tree = tree_of(2);
    for (std::size_t i = 0; i < tree.outlines.size(); ++i) {
        const Limb& limb = tree.limbs.limbs[i];
        const LimbCurve curve = curve_of(tree.limbs, limb, tree.look);
        for (std::size_t span = 0; span < curve.spans(); ++span) {
            for (const double t : {0.3, 0.6, 0.9}) {
                const Vec2 centre = curve.section({span, t}).centre;
                EXPECT_TRUE(covered(tree, i, centre)) << i << " " << span;
            }
        }
    }
}

// Where a child comes out of its parent no speck of background may show: just outside the
// parent's flank, on the child's centre line, one of the two covers.
TEST(Outline, JointsHaveNoGap) {
    const Tree tree = tree_of(3);
    for (std::size_t i = 1; i < tree.outlines.size(); ++i) {
        const Limb& limb = tree.limbs.limbs[i];
        const LimbCurve curve = curve_of(tree.limbs, limb, tree.look);
        const double reach = 4 * tree.limbs.nodes[limb.parent_node].half_width;
        for (double s = 0; s < reach; s += reach / 60) {
            const Vec2 p = curve.section(curve.walk(0, s)).centre;
            EXPECT_TRUE(covered(tree, i, p)) << i << " at " << s;
        }
    }
}

TEST(Outline, StartsInsideTheWoodThatBearsIt) {
    const Tree tree = tree_of(4);
    for (std::size_t i = 1; i < tree.outlines.size(); ++i) {
        const auto parent = static_cast<std::size_t>(tree.limbs.limbs[i].parent);
        EXPECT_TRUE(covered(tree, parent, tree.outlines[i].points.front())) << i;
    }
}

TEST(Outline, TwigsHaveFewNodes) {
    const Tree tree = tree_of(1);
    for (std::size_t i = 1; i < tree.outlines.size(); ++i) {
        const double nodes = static_cast<double>(tree.outlines[i].verbs.size());
        EXPECT_LE(nodes, 12 + 6.0 * tree.limbs.limbs[i].node_count) << i;
    }
}

}  // namespace edaha
