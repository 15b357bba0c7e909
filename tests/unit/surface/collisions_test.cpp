// SPDX-License-Identifier: MIT
#include "surface/collisions.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "block_meshes.h"
#include "surface/crossings.h"
#include "surface/move.h"

using namespace edaha;

namespace {

struct Scene {
    GrowingMesh mesh;
    std::vector<Vec3> of_faces, normals, moves, slides;
    FaceGrid grid{300, 10};

    Scene(GrowingMesh of, double speed_mm) : mesh(std::move(of)) { move_by(speed_mm); }

    void move_by(double speed_mm) {
        of_faces = face_normals(mesh);
        normals = vertex_normals(mesh, of_faces);
        moves = normals;
        slides.assign(moves.size(), Vec3(0));
        for (Vec3& move : moves)
            move *= speed_mm;
    }
    StepPlan plan() const { return {of_faces, normals, moves, slides}; }
    Facing facing(double near_mm, const RestParams& rest = {}) {
        grid.put_all(boxes_of_ways(mesh, plan(), 2));
        return facing_pairs(mesh, plan(), grid, {near_mm, rest, {}});
    }
    // Faces that may pass through each other within a step.
    std::vector<FacePair> close(std::span<const FacingPair> pairs) {
        const std::vector<std::uint8_t> watched = watched_faces(mesh, of_faces, pairs, {});
        const std::vector<FaceBox> boxes = boxes_of_ways(mesh, plan(), 2);
        return closest(close_faces(mesh, plan(), grid, {{}, watched, boxes, {}}));
    }
};

}  // namespace

TEST(NearestPoint, OverTheInsideAnEdgeAndACorner) {
    const std::array<Vec3, 3> t{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    EXPECT_NEAR(glm::distance(nearest_point(t, {1, 1, 5}), {1, 1, 0}), 0, 1e-12);
    EXPECT_NEAR(glm::distance(nearest_point(t, {2, -3, 1}), {2, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(glm::distance(nearest_point(t, {4, 4, 0}), {2, 2, 0}), 0, 1e-12);
    EXPECT_NEAR(glm::distance(nearest_point(t, {-1, -1, 2}), {0, 0, 0}), 0, 1e-12);
}

// The gap is 100 mm: at 20 mm a step both, it shrinks to 60 mm.
TEST(FacingPairs, AreThoseThatComeNearWithinAStep) {
    Scene scene(two_blocks(1), 20);
    EXPECT_TRUE(scene.facing(59).pairs.empty());
    const Facing facing = scene.facing(80);
    ASSERT_FALSE(facing.pairs.empty());
    for (const FacingPair& pair : facing.pairs) {
        const double y = scene.mesh.position[pair.vertex].y;
        EXPECT_TRUE(y == 1200 || y == 1300) << y;
        const Corners face = corners_of(scene.mesh, pair.face);
        for (const Vec3& corner : face)
            EXPECT_EQ(corner.y, 2500 - y);
        EXPECT_DOUBLE_EQ(pair.distance, 100);
        EXPECT_GE(pair.time, 0);
        EXPECT_LE(pair.time, 1);
    }
}

TEST(FacingPairs, AreNotOfXylemNorOfOneBlock) {
    Scene scene(two_blocks(1), 20);
    std::fill(scene.mesh.tissue.begin(), scene.mesh.tissue.end(), Tissue::xylem);
    EXPECT_TRUE(scene.facing(500).pairs.empty());
    Scene block(block_mesh({4, 4, 4}, 100, {0, 1000, 0}, [](int, int, int) { return true; }), 20);
    EXPECT_TRUE(block.facing(500).pairs.empty());
}

// Blocks that grow at each other, step by step: most vertices rest in most steps, and all that come
// near are found in time.
TEST(FacingPairs, AreFoundInTimeThoughMostVerticesRest) {
    Scene scene(two_blocks(1), 2);
    const RestParams rest{3, 30};
    std::size_t looked = 0, all = 0;
    for (int step = 0; step < 25; ++step) {
        const double gap = 100 - 4 * step;
        const Facing facing = scene.facing(35, rest);
        EXPECT_EQ(facing.pairs.empty(), gap - 35 > 4) << gap;
        for (std::size_t v = 0; v < facing.rest.size(); ++v, ++all)
            looked += scene.mesh.vertex_rest[v] == 0;
        if (!facing.pairs.empty()) break;
        scene.mesh.vertex_rest = facing.rest;
        for (std::size_t v = 0; v < scene.moves.size(); ++v)
            scene.mesh.position[v] += scene.moves[v];
    }
    EXPECT_LT(looked, all / 3);
}

TEST(KeepApart, LeavesTheLeastDistance) {
    Scene scene(two_blocks(1), 70);
    const Facing facing = scene.facing(35);
    keep_apart(scene.mesh, scene.normals, scene.grid, {20, 2, facing.pairs, {}, {}}, scene.moves);
    double low = 0, high = 1e9;
    for (std::uint32_t v = 0; v < scene.mesh.position.size(); ++v) {
        const double before = scene.mesh.position[v].y, after = before + scene.moves[v].y;
        if (before <= 1200) low = std::max(low, after);
        if (before >= 1300) high = std::min(high, after);
    }
    EXPECT_GE(high - low, 20 - 1e-9);
    EXPECT_LE(high - low, 35);
}

// Driven at each other from the side, no face looks at the other's vertices; they stop all the
// same.
TEST(KeepApart, LetsNoWatchedFacePassThroughAnother) {
    Scene scene(two_blocks(1), 0);
    const auto v = static_cast<std::uint32_t>(
        std::find(scene.mesh.position.begin(), scene.mesh.position.end(), Vec3(300, 1200, 200)) -
        scene.mesh.position.begin());
    scene.mesh.tissue[v] = Tissue::apex;
    scene.moves[v] = {0, 130, 0};
    scene.facing(5);
    const std::vector<FacePair> close = scene.close({});
    GrowingMesh moved = scene.mesh;
    moved.position[v] += scene.moves[v];
    EXPECT_FALSE(crossing_faces(moved).empty());
    keep_apart(scene.mesh, scene.normals, scene.grid, {1, 2, {}, close, {}}, scene.moves);
    moved.position[v] = scene.mesh.position[v] + scene.moves[v];
    EXPECT_TRUE(crossing_faces(moved).empty());
}
