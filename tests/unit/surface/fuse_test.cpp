// SPDX-License-Identifier: MIT
#include "surface/fuse.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "block_meshes.h"
#include "surface/channels.h"
#include "surface/crossings.h"
#include "surface/move.h"
#include "surface/remesh.h"
#include "surface/surface_growth.h"

using namespace edaha;

namespace {

std::uint32_t vertex_at(const GrowingMesh& mesh, const Vec3& p) {
    const auto found = std::find(mesh.position.begin(), mesh.position.end(), p);
    return static_cast<std::uint32_t>(found - mesh.position.begin());
}

// Grows a mesh of cambium alone, with sewing and all.
Fusions grow_cambium(GrowingMesh& mesh, int steps) {
    std::vector<Apex> apices(1);
    Fusions sum;
    std::vector<std::uint32_t> suspects;
    std::vector<ClosePair> close;
    FaceGrid grid(300, 10);
    for (int step = 0; step < steps; ++step) {
        std::vector<Vec3> of_faces = face_normals(mesh), normals = vertex_normals(mesh, of_faces);
        const auto moves_of = [](std::vector<Vec3> moves) {
            for (Vec3& move : moves)
                move *= 3.0;
            return moves;
        };
        std::vector<Vec3> moves = moves_of(normals), slides(moves.size(), Vec3(0));
        std::vector<FaceBox> boxes;
        const auto face = [&] {
            boxes = boxes_of_ways(mesh, {of_faces, normals, moves, slides}, 3.5);
            grid.put_all(boxes);
            return facing_pairs(mesh, {of_faces, normals, moves, slides}, grid, {});
        };
        Facing facing = face();
        const Fusions now = fuse_facing(mesh, apices, facing.pairs, normals, {{}, &grid});
        sum.sewn += now.sewn;
        sum.pinned = now.pinned;
        of_faces = face_normals(mesh);
        normals = vertex_normals(mesh, of_faces);
        moves = moves_of(normals);
        slides.assign(moves.size(), Vec3(0));
        facing = face();
        mesh.vertex_rest = facing.rest;
        const auto watched = watched_faces(mesh, of_faces, facing.pairs, suspects);
        close = close_faces(mesh, {of_faces, normals, moves, slides}, grid,
                            {{}, watched, boxes, close});
        mesh.last = mesh.position;
        limit_moves(mesh, of_faces, moves);
        suspects =
            keep_apart(mesh, normals, grid, {17.5, 3.5, facing.pairs, closest(close), {}}, moves);
        for (std::size_t v = 0; v < moves.size(); ++v)
            mesh.position[v] += moves[v];
        remesh(mesh, apices, {150, 70, 0, true, &grid});
        close_channels(mesh, {70, 2000});
        EXPECT_TRUE(faults(mesh).empty()) << step << ": " << faults(mesh).front();
    }
    return sum;
}

// Whether p is in the wood: by a ray, that goes through faces outwards once more than inwards.
bool is_inside(const GrowingMesh& mesh, const Vec3& p) {
    int sum = 0;
    for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f) {
        if (!mesh.is_face(f)) continue;
        const Corners t = corners_of(mesh, f);
        const auto side = [&](const Vec3& a, const Vec3& b) {
            return (b.x - a.x) * (p.z - a.z) - (b.z - a.z) * (p.x - a.x);
        };
        const double c = side(t[0], t[1]), a = side(t[1], t[2]), b = side(t[2], t[0]);
        if (!((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0))) continue;
        if ((a * t[0].y + b * t[1].y + c * t[2].y) / (a + b + c) > p.y) sum += a > 0 ? -1 : 1;
    }
    return sum > 0;
}

SurfaceParams branch_into_trunk() {
    SurfaceParams params;
    params.rules =
        "axiom: A(0)\n"
        "A(t) : t == 30 -> bud(90, 0, 5)[speed(40) B(0)] A(t + 1)\n"
        "A(t) -> A(t + 1)\n"
        "B(t) : t < 20 -> B(t + 1)\n"
        "B(t) -> ^(5) B(t + 1)\n";
    return params;
}

}  // namespace

TEST(Sew, JoinsTwoPiecesOrMakesAHandle) {
    GrowingMesh mesh = two_blocks(1);
    ASSERT_EQ(euler_number_of(mesh), 4);
    const double volume = volume_of(mesh);
    ASSERT_TRUE(sew(mesh, vertex_at(mesh, {200, 1200, 200}), vertex_at(mesh, {200, 1300, 200})));
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_EQ(euler_number_of(mesh), 2);
    EXPECT_GT(volume_of(mesh), volume);
    EXPECT_TRUE(crossing_faces(mesh).empty());
}

// The tube between the loops of one block's lid and the other's floor, of cells 100 mm wide and
// six corners (a square with two cut off): a prism.
TEST(Sew, AddsThePrismBetweenTheLoops) {
    GrowingMesh mesh = two_blocks(1);
    const double volume = volume_of(mesh);
    const std::uint32_t a = vertex_at(mesh, {200, 1200, 200}),
                        b = vertex_at(mesh, {200, 1300, 200});
    double area = 0;
    std::vector<Vec3> loop;
    mesh.for_each_out(a, [&](std::uint32_t h) { loop.push_back(mesh.position[mesh.target(h)]); });
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 &p = loop[i], &q = loop[(i + 1) % loop.size()];
        area += (p.x * q.z - p.z * q.x) / 2;
    }
    ASSERT_TRUE(sew(mesh, a, b));
    // The loops are mirrored, so the tube leans between them: not just its middle section.
    EXPECT_NEAR(volume_of(mesh) - volume, std::abs(area) * 100, 0.25 * std::abs(area) * 100);
}

TEST(Sew, RefusesLoopsThatShareOrJoinVertices) {
    GrowingMesh mesh = two_blocks(1);
    const GrowingMesh before = mesh;
    const std::uint32_t a = vertex_at(mesh, {100, 1200, 200});
    for (const double x : {200.0, 300.0, 400.0})
        EXPECT_FALSE(sew(mesh, a, vertex_at(mesh, {x, 1200, 200}))) << x;
    EXPECT_FALSE(sew(mesh, a, a));
    EXPECT_EQ(mesh.origin, before.origin);
    EXPECT_EQ(mesh.twin, before.twin);
}

TEST(Sew, RefusesWhatIsBarred) {
    GrowingMesh mesh = two_blocks(1);
    const SewLimits limits{[](const Vec3&, const Vec3&, const Vec3&) { return true; }, nullptr};
    EXPECT_FALSE(
        sew(mesh, vertex_at(mesh, {200, 1200, 200}), vertex_at(mesh, {200, 1300, 200}), limits));
    EXPECT_EQ(euler_number_of(mesh), 4);
}

TEST(Sew, EndsPhloemAtWhatGoes) {
    GrowingMesh mesh = two_blocks(1);
    const std::uint32_t below = vertex_at(mesh, {100, 1200, 200}),
                        a = vertex_at(mesh, {200, 1200, 200}),
                        above = vertex_at(mesh, {300, 1200, 200});
    mesh.phloem_up[below] = a;
    mesh.phloem_down[a] = below;
    mesh.phloem_up[a] = above;
    mesh.phloem_down[above] = a;
    ASSERT_TRUE(sew(mesh, a, vertex_at(mesh, {200, 1300, 200})));
    EXPECT_EQ(mesh.phloem_up[below], kNone);
    EXPECT_EQ(mesh.phloem_down[above], kNone);
    EXPECT_TRUE(faults(mesh).empty());
}

TEST(FuseFacing, PinsBudsAndXylem) {
    GrowingMesh mesh = two_blocks(1);
    const std::vector<Vec3> of_faces = face_normals(mesh), normals = vertex_normals(mesh, of_faces);
    std::fill(mesh.is_bud.begin(), mesh.is_bud.end(), 1);
    std::vector<Apex> apices(1);
    const std::vector<Vec3> slides(normals.size(), Vec3(0));
    FaceGrid grid(300, 0);
    grid.put_all(boxes_of_ways(mesh, {of_faces, normals, normals, slides}, 0));
    const Facing facing =
        facing_pairs(mesh, {of_faces, normals, normals, slides}, grid, {150, {}, {}});
    const Fusions fusions = fuse_facing(mesh, apices, facing.pairs, normals);
    EXPECT_EQ(fusions.sewn, 0U);
    EXPECT_GE(fusions.pinned, 18U);  // 3 x 3 inner vertices of each side
}

// Two plates that hang together on one side, as a C, grow at each other until no gap is left.
TEST(FuseFacing, ClosesAC) {
    GrowingMesh mesh = block_mesh({10, 6, 8}, 100, {0, 1000, 0},
                                  [](int x, int y, int) { return y < 2 || y >= 4 || x < 2; });
    std::fill(mesh.thickening.begin(), mesh.thickening.end(), 3.0);
    const Fusions fusions = grow_cambium(mesh, 100);
    EXPECT_GE(fusions.sewn, 1U);
    EXPECT_TRUE(crossing_faces(mesh).empty());
    int inside = 0, all = 0;
    for (double x = 203; x < 1000; x += 40)
        for (double z = 3; z < 800; z += 40)
            ++all, inside += is_inside(mesh, {x, 1300.7, z});
    EXPECT_GE(inside, 0.95 * all) << inside << " of " << all;
}

// A branch that bends back into its trunk grows on to it; its apex ends there.
TEST(FuseFacing, EndsAnApexInTheTrunk) {
    SurfaceGrowth growth(branch_into_trunk(), KeyedRandom(1, 1, 1));
    for (int i = 0; i < 200; ++i) {
        growth.step();
        ASSERT_TRUE(faults(growth.mesh()).empty()) << i << ": " << faults(growth.mesh()).front();
    }
    EXPECT_GE(growth.report().fusions, 1U);
    ASSERT_EQ(growth.apices().size(), 2U);
    EXPECT_TRUE(growth.apices()[0].grows);
    EXPECT_FALSE(growth.apices()[1].grows);
    EXPECT_TRUE(crossing_faces(growth.mesh()).empty());
}

TEST(FuseFacing, IsTheSameWithAnyThreads) {
    const auto grown = [] {
        SurfaceGrowth growth(branch_into_trunk(), KeyedRandom(1, 1, 1));
        for (int i = 0; i < 170; ++i)
            growth.step();
        EXPECT_GE(growth.report().fusions, 1U);
        return growth.mesh();
    };
    const GrowingMesh many = grown();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const GrowingMesh alone = grown();
    EXPECT_EQ(many.origin, alone.origin);
    EXPECT_EQ(many.position, alone.position);
}
