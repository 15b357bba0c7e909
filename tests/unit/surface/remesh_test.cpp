// SPDX-License-Identifier: MIT
#include "surface/remesh.h"

#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "surface/crossings.h"

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

// A block, 200 high, with a groove down to the middle of its top and along all of it. Halfway, the
// groove's rims have a corner each that faces the other, `wide` from it.
GrowingMesh grooved_block(double wide) {
    const double half = wide / 2;
    const Vec3 outline[] = {{-150, 0, 0}, {150, 0, 0},     {150, 200, 0}, {half, 200, 0},
                            {0, 100, 0},  {-half, 200, 0}, {-150, 200, 0}};
    std::vector<Vec3> points(std::begin(outline), std::end(outline));
    for (const Vec3& p : outline)
        points.push_back(p + Vec3(0, 0, 120));
    points.push_back({half, 200, 60});   // 14
    points.push_back({-half, 200, 60});  // 15
    std::vector<Triangle> faces{{0, 1, 8},   {0, 8, 7},    {1, 2, 9},   {1, 9, 8},   {6, 0, 7},
                                {6, 7, 13},  {2, 3, 14},   {2, 14, 9},  {14, 10, 9}, {3, 4, 14},
                                {4, 11, 14}, {14, 11, 10}, {4, 5, 15},  {4, 15, 11}, {15, 12, 11},
                                {5, 6, 15},  {15, 6, 13},  {15, 13, 12}};
    for (const auto& [a, b, c] :
         {std::tuple(0U, 1U, 4U), std::tuple(1U, 2U, 4U), std::tuple(2U, 3U, 4U),
          std::tuple(4U, 5U, 6U), std::tuple(4U, 6U, 0U)}) {
        faces.push_back({a, c, b});
        faces.push_back({a + 7, b + 7, c + 7});
    }
    return growing_mesh(points, faces);
}

GrowingMesh after_closing(double wide) {
    GrowingMesh mesh = grooved_block(wide);
    EXPECT_TRUE(crossing_faces(mesh).empty());
    remesh(mesh, std::vector<Apex>(1), {.split_mm = 1000, .merge_mm = 70, .flips = false});
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_TRUE(crossing_faces(mesh).empty());
    return mesh;
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

TEST(Remesh, ClosesFoldsWhoseFlanksMeet) {
    const GrowingMesh mesh = after_closing(40);
    EXPECT_EQ(mesh.vertices(), 15U);
    EXPECT_NE(vertex_at(mesh, {0, 200, 60}), kNone);  // both corners: a bridge over the groove
    EXPECT_EQ(vertex_at(mesh, {20, 200, 60}), kNone);
    EXPECT_EQ(vertex_at(mesh, {-20, 200, 60}), kNone);
    // No edge is left at the bottom of the fold, below the bridge.
    const std::uint32_t bottom = vertex_at(mesh, {0, 100, 0});
    ASSERT_NE(bottom, kNone);
    mesh.for_each_out(bottom, [&](std::uint32_t h) {
        EXPECT_NE(mesh.position[mesh.target(h)], Vec3(0, 100, 120));
    });
}

TEST(Remesh, LeavesFoldsOpenThatAreWiderThanTheShortestEdge) {
    const GrowingMesh mesh = after_closing(80);
    EXPECT_EQ(mesh.vertices(), 16U);
    EXPECT_NE(vertex_at(mesh, {40, 200, 60}), kNone);
    EXPECT_NE(vertex_at(mesh, {-40, 200, 60}), kNone);
}
