// SPDX-License-Identifier: MIT
#include "surface/crossings.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "block_meshes.h"

using namespace edaha;

namespace {

const Corners kFlat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

// Two tetrahedra: the tip of the second at this height over a face of the first.
GrowingMesh spike_over_face(double tip) {
    return growing_mesh(
        {{0, 0, 0},
         {4, 0, 0},
         {0, 4, 0},
         {0, 0, -4},
         {1, 1.1, tip},
         {1.5, 1, 3},
         {0.5, 1.5, 3},
         {0.6, 0.4, 3}},
        {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {4, 6, 5}, {4, 7, 6}, {4, 5, 7}, {5, 6, 7}});
}

}  // namespace

TEST(TrianglesCross, WhereAnEdgePassesThroughTheInside) {
    EXPECT_TRUE(triangles_cross(kFlat, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 1)}));
    EXPECT_TRUE(triangles_cross({Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 1)}, kFlat));
    EXPECT_FALSE(triangles_cross(kFlat, {Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(9, 9, 1)}));
    EXPECT_FALSE(triangles_cross(kFlat, {Vec3(1, 1, 0.01), Vec3(1, 1, 1), Vec3(9, 9, 1)}));
}

TEST(TrianglesCross, NotWhereTheyTouch) {
    EXPECT_FALSE(
        triangles_cross(kFlat, {Vec3(1, 1, 0), Vec3(1, 2, 1), Vec3(2, 1, 1)}));  // a corner
    EXPECT_FALSE(triangles_cross(kFlat, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 1)}));  // an edge
    EXPECT_FALSE(triangles_cross(kFlat, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)}));  // flat
    EXPECT_FALSE(triangles_cross(kFlat, {Vec3(2, 0, -1), Vec3(2, 0, 1), Vec3(2, -3, 0)}));  // edges
}

TEST(TrianglesCross, BesidesTheCornerThatTheyShare) {
    EXPECT_FALSE(triangles_cross(kFlat, {kFlat[0], Vec3(1, 1, 1), Vec3(1, 2, 1)}));
    EXPECT_FALSE(triangles_cross(kFlat, {kFlat[0], kFlat[1], Vec3(1, 1, 1)}));
    EXPECT_TRUE(triangles_cross(kFlat, {kFlat[0], Vec3(1, 1, 1), Vec3(1.2, 1, -1)}));
}

TEST(CrossingFaces, CountsEachPairOnce) {
    EXPECT_TRUE(crossing_faces(spike_over_face(0.5)).empty());
    EXPECT_TRUE(crossing_faces(spike_over_face(0)).empty());
    const auto found = crossing_faces(spike_over_face(-0.2));
    using Pair = std::array<std::uint32_t, 2>;
    EXPECT_EQ(found, (std::vector<Pair>{{0, 4}, {0, 5}, {0, 6}}));
}

// Two blocks pushed into each other: what the grid finds is what all pairs give, whatever the
// threads.
TEST(CrossingFaces, FindsWhatAllPairsGive) {
    GrowingMesh mesh = two_blocks(1);
    for (Vec3& p : mesh.position)
        if (p.y > 1250) p += Vec3(33, -161, 21);
    std::vector<std::array<std::uint32_t, 2>> expected;
    const auto faces = static_cast<std::uint32_t>(mesh.origin.size() / 3);
    for (std::uint32_t f = 0; f < faces; ++f)
        for (std::uint32_t g = f + 1; g < faces; ++g)
            if (triangles_cross(corners_of(mesh, f), corners_of(mesh, g)))
                expected.push_back({f, g});
    EXPECT_GT(expected.size(), 20U);
    EXPECT_EQ(crossing_faces(mesh), expected);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(crossing_faces(mesh), expected);
}
