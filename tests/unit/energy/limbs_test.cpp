// SPDX-License-Identifier: MIT
#include "energy/limbs.h"

#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "energy/grow.h"
#include "energy/limb_curve.h"

namespace edaha {
namespace {

struct Tree {
    EnergyParams params;
    LookParams look;
    Skeleton skeleton;
    Limbs limbs;
};

Tree tree_of(TreeType type, std::uint64_t seed, double gnarl = 0.3) {
    Tree tree;
    tree.params.growth.type = type;
    tree.params.variant.seed = seed;
    tree.params.space.candidates = 4;
    tree.params.space.drop = seed % 2 == 0 ? 0.8 : 0;
    tree.look.gnarl = gnarl;
    tree.skeleton = grow(tree.params);
    tree.limbs = make_limbs(tree.skeleton, tree.params, tree.look);
    return tree;
}

}  // namespace

TEST(Limbs, EveryBranchIsOnOneLimbAndEveryForkStartsTheRest) {
    for (const TreeType type : {TreeType::a, TreeType::b}) {
        const Tree tree = tree_of(type, 3, 0);
        std::size_t branches = 0;
        for (const Limb& limb : tree.limbs.limbs)
            branches += limb.node_count - 1;
        EXPECT_EQ(branches, tree.skeleton.branches.size());
        for (const Limb& limb : tree.limbs.limbs) {
            if (limb.parent < 0) continue;
            // It starts exactly on its parent's node.
            EXPECT_EQ(tree.limbs.nodes[limb.first_node].position,
                      tree.limbs.nodes[limb.parent_node].position);
            EXPECT_EQ(limb.order,
                      tree.limbs.limbs[static_cast<std::size_t>(limb.parent)].order + 1);
        }
    }
}

TEST(Limbs, WidthsFallMonotonicallyAndNoChildIsWiderThanItsParent) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Tree tree = tree_of(TreeType::a, seed);
        for (const Limb& limb : tree.limbs.limbs) {
            const LimbCurve curve(tree.limbs.nodes_of(limb));
            double last = limb.parent < 0 ? 1e9 : tree.limbs.nodes[limb.parent_node].half_width;
            for (std::size_t span = 0; span < curve.spans(); ++span) {
                for (double t = 0; t <= 1; t += 0.05) {
                    const double now = curve.section({span, t}).half_width;
                    EXPECT_LE(now, last + 1e-12);
                    EXPECT_GT(now, 0);
                    last = now;
                }
            }
        }
    }
}

TEST(Limbs, CentreLinesHaveNoJumpOfDirectionOrCurvature) {
    const Tree tree = tree_of(TreeType::a, 5);
    for (const Limb& limb : tree.limbs.limbs) {
        const auto nodes = tree.limbs.nodes_of(limb);
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
            // Second derivatives by chord length, from either side of the node.
            const auto bend = [&](std::size_t a, std::size_t b, bool at_end) {
                const double h = glm::distance(nodes[a].position, nodes[b].position);
                const Vec2 rise = (nodes[b].position - nodes[a].position) / h;
                return at_end
                           ? (nodes[a].velocity * 2.0 + nodes[b].velocity * 4.0 - rise * 6.0) / h
                           : (rise * 6.0 - nodes[a].velocity * 4.0 - nodes[b].velocity * 2.0) / h;
            };
            const Vec2 jump = bend(i - 1, i, true) - bend(i, i + 1, false);
            EXPECT_LT(glm::length(jump), 1e-9);
        }
    }
}

TEST(Limbs, IdsAreUniqueAndStayWhenLooksChange) {
    for (const TreeType type : {TreeType::a, TreeType::b}) {
        const Tree tree = tree_of(type, 2), other = tree_of(type, 2, 0.9);
        std::set<std::string> ids;
        for (std::size_t i = 0; i < tree.limbs.limbs.size(); ++i) {
            const std::string id = tree.limbs.id(tree.limbs.limbs[i]);
            EXPECT_TRUE(ids.insert(id).second) << id;
            EXPECT_EQ(id, other.limbs.id(other.limbs.limbs[i]));
        }
        EXPECT_TRUE(ids.count("trunk"));
    }
}

TEST(Limbs, ATreeOfOneBranchIsATrunk) {
    EnergyParams params;
    params.growth.energy = 1;
    const Limbs limbs = make_limbs(grow(params), params, LookParams{});
    ASSERT_EQ(limbs.limbs.size(), 1U);
    EXPECT_TRUE(limbs.limbs[0].terminal);
}

}  // namespace edaha
