// SPDX-License-Identifier: MIT
#include "surface/face_grid.h"

#include <set>

#include <gtest/gtest.h>

#include "base/keyed_random.h"
#include "block_meshes.h"

using namespace edaha;

namespace {

// With corners moved at random, on both sides of 0.
GrowingMesh rough_blocks() {
    GrowingMesh mesh = two_blocks(1);
    const KeyedRandom random(1, 2, 3);
    for (std::uint32_t v = 0; v < mesh.position.size(); ++v) {
        const auto number = [&](std::uint32_t i) { return random.uniform(v, 1, i) - 0.5; };
        mesh.position[v] += 90.0 * Vec3(number(0), number(1), number(2)) - Vec3(250, 1200, 250);
    }
    return mesh;
}

FaceBox box_of_face(const GrowingMesh& mesh, std::uint32_t f) {
    return box_round(mesh.position[mesh.origin[3 * f]], mesh.position[mesh.origin[3 * f + 1]],
                     mesh.position[mesh.origin[3 * f + 2]]);
}

}  // namespace

TEST(FaceGrid, FindsAllFacesOfABoxAndNoOthers) {
    const GrowingMesh mesh = rough_blocks();
    for (const double cell : {40.0, 150.0, 5000.0}) {
        const FaceGrid grid(mesh, cell);
        for (int i = -3; i < 3; ++i) {
            const FaceBox box = box_round(Vec3(100.0 * i, 37, -50), Vec3(100.0 * i + 80, 90, 60));
            std::set<std::uint32_t> found, expected;
            grid.visit(box, [&](std::uint32_t f) { found.insert(f); });
            for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f)
                if (box_of_face(mesh, f).meets(box)) expected.insert(f);
            EXPECT_EQ(found, expected) << cell << " " << i;
        }
    }
}

TEST(FaceGrid, FindsEachPairOnce) {
    const GrowingMesh mesh = rough_blocks();
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    const FaceGrid grid(mesh, 120);
    for (std::size_t bucket = 0; bucket < grid.buckets(); ++bucket)
        grid.visit_pairs(
            bucket, [&](std::uint32_t f, std::uint32_t g) { found.insert(std::minmax(f, g)); });
    const auto faces = static_cast<std::uint32_t>(mesh.origin.size() / 3);
    for (std::uint32_t f = 0; f < faces; ++f)
        for (std::uint32_t g = f + 1; g < faces; ++g)
            if (box_of_face(mesh, f).meets(box_of_face(mesh, g))) expected.insert({f, g});
    EXPECT_GT(expected.size(), 500U);
    EXPECT_EQ(found, expected);
}
