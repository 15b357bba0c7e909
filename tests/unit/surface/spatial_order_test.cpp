// SPDX-License-Identifier: MIT
#include "surface/spatial_order.h"

#include <algorithm>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "surface/move.h"
#include "surface/surface_growth.h"
#include "surface/surface_mesh.h"
#include "unit/surface/grown.h"

namespace edaha {
namespace {

SurfaceParams forked() {
    SurfaceParams params = trunk(60);
    params.rules =
        "axiom: A(0)\nA(t) : t == 20 -> bud(60, 0, 5)[speed(40) B] A(t + 1)\n"
        "A(t) -> A(t + 1)\nB -> B\n";
    return params;
}

// As things are called by names of vertices.
std::map<std::uint32_t, std::uint32_t> lines_by_name(const GrowingMesh& mesh) {
    std::map<std::uint32_t, std::uint32_t> lines;
    for (std::uint32_t v = 0; v < mesh.out.size(); ++v) {
        if (mesh.is_vertex(v) && mesh.phloem_up[v] != kNone)
            lines[mesh.name[v]] = mesh.name[mesh.phloem_up[v]];
    }
    return lines;
}

// How far the ends of edges are from each other in memory, on average.
double spread(const GrowingMesh& mesh) {
    double sum = 0, count = 0;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h) {
        if (mesh.origin[h] == kNone) continue;
        sum += std::abs(double(mesh.origin[h]) - double(mesh.target(h)));
        ++count;
    }
    return sum / count;
}

TEST(SortInSpace, LeavesTheSurfaceWhatItWas) {
    const SurfaceGrowth growth = grown(forked());
    GrowingMesh mesh = growth.mesh();
    free_vertex(mesh, new_vertex(mesh));  // a place that is free
    const GrowingMesh before = mesh;
    const Renumbering numbers = sort_in_space(mesh, 70);
    EXPECT_TRUE(faults(mesh).empty()) << faults(mesh).front();
    EXPECT_EQ(mesh.vertices(), before.vertices());
    EXPECT_EQ(mesh.vertices(), mesh.position.size());
    EXPECT_EQ(mesh.faces(), before.faces());
    EXPECT_EQ(lines_by_name(mesh), lines_by_name(before));
    for (std::uint32_t v = 0; v < before.out.size(); ++v) {
        if (!before.is_vertex(v)) continue;
        const std::uint32_t now = numbers.vertex[v];
        EXPECT_EQ(mesh.position[now], before.position[v]);
        EXPECT_EQ(mesh.tissue[now], before.tissue[v]);
        EXPECT_EQ(mesh.name[now], before.name[v]);
    }
    for (std::uint32_t f = 0; f < before.origin.size() / 3; ++f) {
        if (!before.is_face(f)) continue;
        for (std::uint32_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.origin[3 * numbers.face[f] + k],
                      numbers.vertex[before.origin[3 * f + k]]);
    }
}

// Vertices numbered at random come to lie near their neighbours.
TEST(SortInSpace, BringsNeighboursTogether) {
    GrowingMesh mesh = grown(forked()).mesh();
    GrowingMesh far = mesh;
    for (Vec3& p : far.position)
        p = 7919.0 * glm::fract(p * 0.618);
    sort_in_space(far, 70);
    const double scattered = spread(far);
    sort_in_space(mesh, 70);
    EXPECT_LT(spread(mesh), scattered / 2);
}

// Where sprigs stand follows from the names of vertices, not from their numbers: they stay where
// they are from frame to frame.
TEST(SortInSpace, MovesNoSprig) {
    const SurfaceParams params = forked();
    const SurfaceGrowth growth = grown(params);
    GrowingMesh mesh = growth.mesh();
    const KeyedRandom random(1, 1, 1);
    const Mesh before = surface_mesh(mesh, growth.apices(), params, random);
    std::vector<Apex> apices = growth.apices();
    const Renumbering numbers = sort_in_space(mesh, 30);  // other cells than growth has
    for (Apex& apex : apices)
        apex.vertex = numbers.vertex[apex.vertex];
    const Mesh after = surface_mesh(mesh, apices, params, random);
    ASSERT_GT(before.sites.size(), 20U);
    ASSERT_EQ(after.sites.size(), before.sites.size());
    for (std::size_t i = 0; i < before.sites.size(); ++i)
        EXPECT_EQ(after.sites[i].position, before.sites[i].position) << i;
}

}  // namespace
}  // namespace edaha
