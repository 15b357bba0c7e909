// SPDX-License-Identifier: MIT
#include "mesh/edges.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace edaha {
namespace {

Mesh mesh_of(std::size_t points, std::vector<Triangle> triangles) {
    Mesh mesh;
    mesh.points.resize(points);
    mesh.part_of.resize(triangles.size());
    mesh.triangles = std::move(triangles);
    return mesh;
}

TEST(MeshEdges, of_one_triangle_have_one_side) {
    EXPECT_EQ(mesh_edges(mesh_of(3, {{2, 0, 1}})),
              (std::vector<MeshEdge>{{0, 1, 0, kNone}, {0, 2, kNone, 0}, {1, 2, 0, kNone}}));
}

TEST(MeshEdges, tell_which_triangle_runs_which_way) {
    const Mesh mesh = mesh_of(4, {{0, 1, 2}, {0, 2, 3}});
    const std::vector<MeshEdge> edges = mesh_edges(mesh);
    ASSERT_EQ(edges.size(), 5U);
    EXPECT_EQ(edges[1], (MeshEdge{0, 2, 1, 0}));
}

TEST(MeshEdges, of_a_closed_surface_have_two_sides_each) {
    const std::vector<MeshEdge> edges =
        mesh_edges(mesh_of(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    EXPECT_EQ(edges.size(), 6U);
    EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const MeshEdge& edge) {
        return edge.left != kNone && edge.right != kNone;
    }));
}

TEST(MeshEdges, with_many_triangles_come_several_times) {
    const Mesh fan = mesh_of(6, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {0, 1, 3}});
    const std::vector<MeshEdge> edges = mesh_edges(fan);
    EXPECT_EQ(edges[0], (MeshEdge{0, 1, 0, 1}));
    EXPECT_EQ(edges[1], (MeshEdge{0, 1, 2, 3}));
    EXPECT_EQ(edges[2], (MeshEdge{0, 1, 4, kNone}));
    EXPECT_NE(edges[3].b, 1U);
}

TEST(MeshEdges, leave_out_sides_without_length) {
    EXPECT_EQ(mesh_edges(mesh_of(2, {{0, 0, 1}})), (std::vector<MeshEdge>{{0, 1, 0, 0}}));
    EXPECT_TRUE(mesh_edges(mesh_of(1, {{0, 0, 0}})).empty());
    EXPECT_TRUE(mesh_edges({}).empty());
}

// Whatever the triangles, the edges are sorted and name each side of each triangle once.
TEST(MeshEdges, name_each_side_once) {
    EXPECT_TRUE(rc::check([] {
        const std::uint32_t points = *rc::gen::inRange(1U, 40U);
        const auto corner = rc::gen::inRange(0U, points);
        const auto triangles =
            *rc::gen::container<std::vector<Triangle>>(rc::gen::container<Triangle>(corner));
        const Mesh mesh = mesh_of(points, triangles);
        using Run = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
        std::map<Run, int> expected, actual;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto from = triangles[t][k], to = triangles[t][(k + 1) % 3];
                if (from != to) ++expected[{t, from, to}];
            }
        }
        const std::vector<MeshEdge> edges = mesh_edges(mesh);
        for (const MeshEdge& edge : edges) {
            RC_ASSERT(edge.a < edge.b);
            RC_ASSERT(edge.left != kNone || edge.right != kNone);
            if (edge.left != kNone) ++actual[{edge.left, edge.a, edge.b}];
            if (edge.right != kNone) ++actual[{edge.right, edge.b, edge.a}];
        }
        RC_ASSERT(expected == actual);
        RC_ASSERT(
            std::is_sorted(edges.begin(), edges.end(), [](const MeshEdge& x, const MeshEdge& y) {
                return std::pair(x.a, x.b) < std::pair(y.a, y.b);
            }));
    }));
}

}  // namespace
}  // namespace edaha
