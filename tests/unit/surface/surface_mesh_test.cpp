// SPDX-License-Identifier: MIT
#include "surface/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/mesh_check.h"
#include "surface/grow_surface.h"

using namespace edaha;

namespace {

SurfaceParams forked_tree(std::int64_t steps) {
    SurfaceParams params;
    params.steps = steps;
    params.rules =
        "axiom: A(0)\nA(t) : t == 30 -> bud(60, 0, 5)[speed(40) B] A(t + 1)\n"
        "A(t) -> A(t + 1)\nB -> B\n";
    return params;
}

}  // namespace

TEST(SurfaceMesh, IsOneClosedSurfaceOfBranches) {
    const SurfaceTree tree = grow_surface(forked_tree(100), KeyedRandom(1, 1, 1));
    MeshReport report = validate(tree.mesh);
    EXPECT_GT(report.shared_points, 0U);  // the ring at the foot of the branch
    report.shared_points = 0;
    EXPECT_TRUE(report.sound());
    EXPECT_EQ(report.pieces, 1U);
    ASSERT_EQ(tree.mesh.parts.size(), 2U);
    EXPECT_EQ(tree.mesh.parts[0].name, "trunk");
    EXPECT_EQ(tree.mesh.parts[1].name, "branch-1");
    EXPECT_EQ(tree.mesh.parts[1].parent, 0);
    EXPECT_EQ(tree.mesh.parts[1].order, 1U);
    EXPECT_EQ(tree.report.branches, 2U);
    EXPECT_EQ(tree.report.faces, tree.mesh.triangles.size());
}

// v is the height less the seed's on a straight trunk, and no face spans half of the way round.
TEST(SurfaceMesh, PlacesPointsAlongAndAroundTheTrunk) {
    SurfaceParams params = forked_tree(25);
    const SurfaceTree tree = grow_surface(params, KeyedRandom(1, 1, 1));
    double most = 0;
    for (std::size_t t = 0; t < tree.mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = tree.mesh.points[tree.mesh.triangles[t][k]];
            EXPECT_NEAR(tree.mesh.uv[t][k].y, p.y - params.seed_height_mm, 1e-6);
            most = std::max(most, std::abs(tree.mesh.uv[t][k].x));
        }
    }
    EXPECT_GT(most, 0);
    for (const auto& uv : tree.mesh.uv)
        for (std::size_t k = 1; k < 3; ++k)
            EXPECT_LT(std::abs(uv[k].x - uv[0].x), most);
}

// Thin twigs have little area: their length sees to it that none is bare.
TEST(SurfaceMesh, EachGrowingTipBearsASprig) {
    SurfaceParams params = forked_tree(80);
    params.sprig_spacing_mm = 1000;
    const SurfaceTree tree = grow_surface(params, KeyedRandom(1, 1, 1));
    for (std::uint32_t part = 0; part < 2; ++part) {
        Vec3 tip(0);
        for (std::size_t t = 0; t < tree.mesh.triangles.size(); ++t) {
            if (tree.mesh.part_of[t] != part) continue;
            for (const std::uint32_t point : tree.mesh.triangles[t])
                if (tree.mesh.points[point].y > tip.y) tip = tree.mesh.points[point];
        }
        EXPECT_TRUE(std::ranges::any_of(tree.mesh.sites, [&](const SprigSite& site) {
            return site.part == part && glm::distance(site.position, tip) < params.split_mm;
        })) << part;
    }
}

TEST(SurfaceMesh, WhatTheRulesStopIsDeadwoodWithoutSprigs) {
    SurfaceParams params = forked_tree(80);
    params.sprig_spacing_mm = 50;
    params.rules =
        "axiom: A(0)\nA(t) : t == 30 -> bud(60, 0, 5)[speed(40) B(0)] A(t + 1)\n"
        "A(t) -> A(t + 1)\nB(t) : t > 20 -> stop\nB(t) -> B(t + 1)\n";
    const auto material = [&](const Mesh& mesh) {
        return mesh.materials[mesh.parts[1].material].name;
    };
    EXPECT_EQ(material(grow_surface(params, KeyedRandom(1, 1, 1)).mesh), "wood");
    params.deadwood = true;
    const Mesh mesh = grow_surface(params, KeyedRandom(1, 1, 1)).mesh;
    EXPECT_EQ(material(mesh), "deadwood");
    EXPECT_EQ(mesh.materials[mesh.parts[0].material].name, "wood");
    EXPECT_GT(mesh.sites.size(), 10U);
    EXPECT_TRUE(
        std::ranges::none_of(mesh.sites, [](const SprigSite& site) { return site.part == 1; }));
}
