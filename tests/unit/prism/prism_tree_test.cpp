// SPDX-License-Identifier: MIT
#include "prism/prism_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "solids.h"

namespace edaha {
namespace {

PrismTree tree_of(const PrismParams& params, std::uint64_t seed = 1) {
    return grow_prisms(params, KeyedRandom(1, seed, 1));
}

TEST(PrismTree, EveryPrismIsClosedAndItsVolumeIsAreaTimesLength) {
    PrismParams params;
    params.depth = 7;
    params.radius_spread = 0.6;
    const PrismTree tree = tree_of(params, 3);
    ASSERT_GT(tree.mesh.parts.size(), 20U);
    EXPECT_TRUE(oracles::is_closed(tree.mesh));
    for (std::uint32_t part = 0; part < tree.mesh.parts.size(); ++part) {
        const Mesh& mesh = tree.mesh;
        const Vec3 a = mesh.points[part * 6], b = mesh.points[part * 6 + 1],
                   c = mesh.points[part * 6 + 2];
        const double area = glm::length(glm::cross(b - a, c - a)) / 2;
        const Axis axis = *mesh.parts[part].axis;
        const double expected = area * glm::distance(axis.from, axis.to);
        EXPECT_NEAR(oracles::volume(mesh, part) / expected, 1, 1e-9) << mesh.parts[part].name;
    }
}

TEST(PrismTree, TaperedPrismsAreFrustaAndPointedOnesPyramids) {
    PrismParams params;
    params.two_way = params.mixed = 0;
    params.depth = 3;
    params.taper = 0.5;
    params.pointed = true;
    const PrismTree tree = tree_of(params);
    ASSERT_EQ(tree.mesh.parts.size(), 3U);
    EXPECT_TRUE(oracles::is_closed(tree.mesh));
    double area = 0.75 * std::sqrt(3.0) * params.radius_mm * params.radius_mm;
    const double k = params.taper;
    for (std::uint32_t part = 0; part < 2; ++part) {
        const double length = params.length_mm / (part + 1);
        EXPECT_NEAR(oracles::volume(tree.mesh, part) / (area * length * (1 + k + k * k) / 3), 1,
                    1e-9);
        area *= k * k;
    }
    EXPECT_NEAR(oracles::volume(tree.mesh, 2) / (area * params.length_mm / 3 / 3), 1, 1e-9);
    EXPECT_EQ(tree.mesh.points.size(), 6U + 6 + 4);
}

TEST(PrismTree, JointsLeavePrismsClosed) {
    for (const PrismJoint joint : {PrismJoint::mitre, PrismJoint::weld}) {
        PrismParams params;
        params.depth = 8;
        params.joint = joint;
        params.radius_mm = 3;
        params.taper = 0.9;
        params.pointed = true;
        const PrismTree tree = tree_of(params);
        EXPECT_TRUE(oracles::is_closed(tree.mesh));
        for (std::uint32_t part = 0; part < tree.mesh.parts.size(); ++part)
            EXPECT_GT(oracles::volume(tree.mesh, part), 0);
    }
}

TEST(PrismTree, CountsArePartsByOrder) {
    PrismParams params;
    params.depth = 8;
    params.interference = true;
    const PrismTree tree = tree_of(params);
    const PrismCounts& counts = tree.counts;
    EXPECT_EQ(counts.prisms, tree.mesh.parts.size());
    std::vector<std::size_t> by_order(counts.by_order.size());
    for (const MeshPart& part : tree.mesh.parts)
        ++by_order.at(part.order);
    EXPECT_EQ(by_order, counts.by_order);
    EXPECT_EQ(by_order[0], 1U);
}

TEST(PrismTree, PartsAreNamedByTheWayToThem) {
    PrismParams params;
    params.straight = params.two_way = 0;
    params.both = 1;
    params.depth = 3;
    std::vector<std::string> names;
    for (const MeshPart& part : tree_of(params).mesh.parts)
        names.push_back(part.name);
    EXPECT_EQ(names, (std::vector<std::string>{"trunk-1", "trunk-2", "branch-1a1", "branch-1b1",
                                               "trunk-3", "branch-2a1", "branch-2b1", "branch-1a2",
                                               "branch-1a1a1", "branch-1a1b1", "branch-1b2",
                                               "branch-1b1a1", "branch-1b1b1"}));
    params.depth = 7;
    const Mesh mesh = tree_of(params).mesh;
    std::set<std::string> all;
    for (const MeshPart& part : mesh.parts)
        all.insert(part.name);
    EXPECT_EQ(all.size(), mesh.parts.size());
}

TEST(PrismTree, SitesStandAtTheEndsAndAlongThinPrisms) {
    PrismParams params;
    params.straight = params.mixed = 0;
    params.depth = 5;
    params.site_mm = 3;
    EXPECT_EQ(tree_of(params).mesh.sites.size(), 16U);
    params.along_mm = 2;
    params.along_width_mm = 3;
    const Mesh mesh = tree_of(params).mesh;
    EXPECT_GT(mesh.sites.size(), 16U);
    for (const SprigSite& site : mesh.sites) {
        EXPECT_EQ(site.size, 3);
        EXPECT_NEAR(glm::length(site.direction), 1, 1e-12);
        // On the surface: in the plane of one of its part's triangles, and not inside.
        double nearest = 1;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (mesh.part_of[t] != site.part) continue;
            const auto& [a, b, c] = mesh.triangles[t];
            const Vec3 normal = glm::normalize(
                glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
            const double height = glm::dot(normal, site.position - mesh.points[a]);
            EXPECT_LT(height, 1e-9);
            nearest = std::min(nearest, std::abs(height));
        }
        EXPECT_LT(nearest, 1e-9);
    }
}

PrismParams leafy(FoliageShape shape) {
    PrismParams params;
    params.depth = 7;
    params.straight = params.two_way = 0;
    params.frame = PrismFrame::parallel;
    params.foliage.shape = shape;
    return params;
}

TEST(PrismTree, FoliageIsClosedMassesOfItsOwn) {
    for (const FoliageShape shape :
         {FoliageShape::balls, FoliageShape::tiers, FoliageShape::sprays}) {
        for (const std::int64_t rings : {1, 2, 5}) {
            PrismParams params = leafy(shape);
            params.foliage.rings = rings;
            params.foliage.roughness = 0.2;
            const PrismTree tree = tree_of(params);
            const Mesh& mesh = tree.mesh;
            ASSERT_GT(tree.counts.foliage, 1U);
            EXPECT_EQ(tree.counts.prisms + tree.counts.foliage, mesh.parts.size());
            EXPECT_TRUE(oracles::is_closed(mesh));
            for (std::uint32_t part = 0; part < mesh.parts.size(); ++part) {
                const bool leaves = part >= tree.counts.prisms;
                EXPECT_EQ(mesh.materials.at(mesh.parts[part].material).name,
                          leaves ? "leaf" : "wood");
                EXPECT_EQ(mesh.parts[part].name.starts_with("leaves-"), leaves);
                EXPECT_GT(oracles::volume(mesh, part), 0) << mesh.parts[part].name;
            }
        }
    }
}

// A body of revolution with n corners a ring has n/2 sin(2 pi/n) / pi of the round one's volume.
TEST(PrismTree, SmoothBallsOfManySidesHaveABallsVolume) {
    PrismParams params = leafy(FoliageShape::balls);
    params.foliage.sides = 40;
    params.foliage.rings = 39;
    params.foliage.roughness = params.foliage.size_spread = 0;
    params.foliage.stretch = 1.5;
    const PrismTree tree = tree_of(params);
    const double r = params.foliage.size_mm;
    const double round = 4.0 / 3 * std::numbers::pi * r * r * r * 1.5;
    for (std::size_t part = tree.counts.prisms; part < tree.mesh.parts.size(); ++part) {
        const double volume = oracles::volume(tree.mesh, static_cast<std::uint32_t>(part));
        EXPECT_NEAR(volume / round, 1, 0.02);
    }
}

TEST(PrismTree, FoliageMovesNoBranch) {
    const Mesh bare = tree_of(leafy(FoliageShape::none)).mesh;
    const Mesh balls = tree_of(leafy(FoliageShape::balls)).mesh;
    ASSERT_LT(bare.points.size(), balls.points.size());
    EXPECT_TRUE(std::equal(bare.points.begin(), bare.points.end(), balls.points.begin()));
    EXPECT_EQ(bare.materials.size(), 1U);
}

TEST(PrismTree, TiersStandOnTheTrunkOneAPrism) {
    PrismParams params = leafy(FoliageShape::tiers);
    params.foliage.from = 3;
    const PrismTree tree = tree_of(params);
    EXPECT_EQ(tree.counts.foliage, 5U);  // of depths 3 to 7
    for (std::size_t part = tree.counts.prisms; part < tree.mesh.parts.size(); ++part) {
        const auto bearer = static_cast<std::size_t>(tree.mesh.parts[part].parent);
        EXPECT_TRUE(tree.mesh.parts[bearer].name.starts_with("trunk-"));
    }
}

TEST(PrismTree, AfterItsHalvingsABranchGoesStraightOn) {
    PrismParams params = leafy(FoliageShape::sprays);
    params.halvings = 1;
    params.both = 1;
    const PrismTree tree = tree_of(params);
    // A trunk of 7, and at each of its 6 forks two limbs that reach the same depth.
    EXPECT_EQ(tree.counts.prisms, 7U + 2 * (6 + 5 + 4 + 3 + 2 + 1));
    params.foliage.from = 7;
    EXPECT_EQ(tree_of(params).counts.foliage, 13U);  // a spray a limb, a cone on the trunk
}

TEST(PrismTree, ParentsComeBeforeTheirChildren) {
    PrismParams params;
    params.depth = 8;
    const Mesh mesh = tree_of(params).mesh;
    EXPECT_EQ(mesh.parts[0].parent, -1);
    for (std::size_t i = 1; i < mesh.parts.size(); ++i) {
        ASSERT_GE(mesh.parts[i].parent, 0);
        ASSERT_LT(mesh.parts[i].parent, static_cast<int>(i));
        EXPECT_EQ(mesh.parts[static_cast<std::size_t>(mesh.parts[i].parent)].order + 1,
                  mesh.parts[i].order);
    }
}

}  // namespace
}  // namespace edaha
