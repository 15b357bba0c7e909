// SPDX-License-Identifier: MIT
#include "surface/remesh.h"

#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace edaha;

namespace {

constexpr Tissue kApex = Tissue::apex, kCambium = Tissue::cambium, kXylem = Tissue::xylem;

// Of edge 100: its diagonals are 141 long. Half-edge 1 is the first face's diagonal from 2 to 0.
GrowingMesh hundred_cube() {
    const std::vector<Vec3> points{{0, 0, 0},   {100, 0, 0},   {100, 100, 0},   {0, 100, 0},
                                   {0, 0, 100}, {100, 0, 100}, {100, 100, 100}, {0, 100, 100}};
    return growing_mesh(points, {{0, 2, 1},
                                 {0, 3, 2},
                                 {4, 5, 6},
                                 {4, 6, 7},
                                 {0, 1, 5},
                                 {0, 5, 4},
                                 {1, 2, 6},
                                 {1, 6, 5},
                                 {2, 3, 7},
                                 {2, 7, 6},
                                 {3, 0, 4},
                                 {3, 4, 7}});
}

std::uint32_t vertex_at(const GrowingMesh& mesh, const Vec3& place) {
    for (std::uint32_t v = 0; v < mesh.position.size(); ++v)
        if (mesh.is_vertex(v) && glm::distance(mesh.position[v], place) < 1e-9) return v;
    return kNone;
}

// Ends 0 and 2 of a diagonal, of these tissues; what the new vertex is.
Tissue after_split(Tissue a, Tissue b) {
    GrowingMesh mesh = hundred_cube();
    std::tie(mesh.tissue[0], mesh.tissue[2]) = std::tuple(a, b);
    remesh(mesh, std::vector<Apex>(1), {.split_mm = 130, .merge_mm = 10, .flips = false});
    EXPECT_TRUE(faults(mesh).empty());
    const std::uint32_t m = vertex_at(mesh, {50, 50, 0});
    EXPECT_NE(m, kNone);
    return mesh.tissue[m];
}

// An edge of 50 from 0 to a vertex at (50, 0, 0), of these tissues, has shrunk.
GrowingMesh after_merge(Tissue a, Tissue b) {
    GrowingMesh mesh = hundred_cube();
    std::uint32_t h = mesh.out[0];
    while (mesh.target(h) != 1)
        h = GrowingMesh::next(mesh.twin[h]);
    const std::uint32_t m = split_edge(mesh, h);
    mesh.last[m] = {55, 0, 0};
    std::tie(mesh.tissue[0], mesh.tissue[m]) = std::tuple(a, b);
    remesh(mesh, std::vector<Apex>(1), {.split_mm = 1000, .merge_mm = 60, .flips = false});
    EXPECT_TRUE(faults(mesh).empty());
    return mesh;
}

void expect_merged(Tissue a, Tissue b, const Vec3& place, Tissue tissue) {
    const GrowingMesh mesh = after_merge(a, b);
    EXPECT_EQ(mesh.vertices(), 8U);
    const std::uint32_t v = vertex_at(mesh, place);
    ASSERT_NE(v, kNone);
    EXPECT_EQ(mesh.tissue[v], tissue);
}

}  // namespace

TEST(Remesh, GivesNewVerticesTheTissueOfTable1) {
    EXPECT_EQ(after_split(kApex, kApex), kCambium);
    EXPECT_EQ(after_split(kApex, kCambium), kCambium);
    EXPECT_EQ(after_split(kApex, kXylem), kCambium);
    EXPECT_EQ(after_split(kCambium, kCambium), kCambium);
    EXPECT_EQ(after_split(kCambium, kXylem), kXylem);
    EXPECT_EQ(after_split(kXylem, kXylem), kXylem);
}

TEST(Remesh, MergesVerticesByTable2) {
    const Vec3 first(0, 0, 0), middle(25, 0, 0), second(50, 0, 0);
    expect_merged(kApex, kCambium, first, kApex);
    expect_merged(kCambium, kApex, second, kApex);
    expect_merged(kApex, kXylem, first, kApex);
    expect_merged(kCambium, kCambium, middle, kCambium);
    expect_merged(kCambium, kXylem, first, kCambium);
    expect_merged(kXylem, kCambium, second, kCambium);
    expect_merged(kXylem, kXylem, middle, kXylem);
    EXPECT_EQ(after_merge(kApex, kApex).vertices(), 9U);
}
