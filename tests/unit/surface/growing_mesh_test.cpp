// SPDX-License-Identifier: MIT
#include "surface/growing_mesh.h"

#include <array>
#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/keyed_random.h"

using namespace edaha;

namespace {

GrowingMesh tetrahedron() {
    return growing_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

// A cube of edge 2: its faces are flat, so splits keep volume and area.
GrowingMesh cube() {
    const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0},
                                   {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
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

std::size_t edge_count(const GrowingMesh& mesh) {
    std::size_t count = 0;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h)
        if (mesh.origin[h] != kNone && h < mesh.twin[h]) ++count;
    return count;
}

long euler_number(const GrowingMesh& mesh) {
    return static_cast<long>(mesh.vertices()) - static_cast<long>(edge_count(mesh)) +
           static_cast<long>(mesh.faces());
}

struct AreaAndVolume {
    double area = 0, volume = 0;
};

AreaAndVolume measure_mesh(const GrowingMesh& mesh) {
    AreaAndVolume sum;
    for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f) {
        if (!mesh.is_face(f)) continue;
        const Vec3 a = mesh.position[mesh.origin[3 * f]], b = mesh.position[mesh.origin[3 * f + 1]],
                   c = mesh.position[mesh.origin[3 * f + 2]];
        sum.area += glm::length(glm::cross(b - a, c - a)) / 2;
        sum.volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

class MeshDice {
  public:
    explicit MeshDice(std::uint64_t seed) : random_(seed, 0, 0) {}
    std::uint32_t below(std::size_t end) {
        return static_cast<std::uint32_t>(random_.uniform(++count_, 1) * static_cast<double>(end));
    }
    std::uint32_t half_edge(const GrowingMesh& mesh) {
        std::uint32_t h = below(mesh.origin.size());
        while (mesh.origin[h] == kNone)
            h = below(mesh.origin.size());
        return h;
    }

  private:
    KeyedRandom random_;
    Key count_ = 0;
};

// Carries one random operation out, if it may be; returns which.
std::uint32_t random_step(GrowingMesh& mesh, MeshDice& dice) {
    const std::uint32_t what = dice.below(3), h = dice.half_edge(mesh);
    if (what == 0 && mesh.faces() < 200) {
        split_edge(mesh, h);
    } else if (what == 1 && can_collapse(mesh, h)) {
        collapse_edge(mesh, h);
    } else if (what == 2 && can_flip(mesh, h)) {
        flip_edge(mesh, h);
    } else {
        return 3;
    }
    return what;
}

}  // namespace

TEST(GrowingMesh, GivesNewVerticesInTurnAndTheLastFreedFirst) {
    GrowingMesh mesh;
    EXPECT_EQ(new_vertex(mesh), 0U);
    EXPECT_EQ(new_vertex(mesh), 1U);
    EXPECT_EQ(new_vertex(mesh), 2U);
    free_vertex(mesh, 0);
    free_vertex(mesh, 1);
    EXPECT_EQ(new_vertex(mesh), 1U);
    EXPECT_EQ(new_vertex(mesh), 0U);
    EXPECT_EQ(new_vertex(mesh), 3U);
}

TEST(GrowingMesh, IsMadeOfAClosedMesh) {
    const GrowingMesh mesh = cube();
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_EQ(mesh.vertices(), 8U);
    EXPECT_EQ(mesh.faces(), 12U);
    EXPECT_EQ(euler_number(mesh), 2);
    EXPECT_NEAR(measure_mesh(mesh).volume, 8, 1e-12);
}

TEST(GrowingMesh, RefusesWhatIsNoManifold) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    // Open; turned; a point without triangle; a corner twice; a point that is not there.
    EXPECT_THROW(growing_mesh(points, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}), IoError);
    EXPECT_THROW(growing_mesh(points, {{0, 1, 2}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}), IoError);
    EXPECT_THROW(growing_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}},
                              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}),
                 IoError);
    EXPECT_THROW(growing_mesh(points, {{0, 0, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}), IoError);
    EXPECT_THROW(growing_mesh(points, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}}), IoError);
    // Two tetrahedra that share a point only: it has two fans.
    EXPECT_THROW(
        growing_mesh(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
            {{0, 2, 1},
             {0, 1, 3},
             {0, 3, 2},
             {1, 2, 3},
             {0, 4, 5},
             {0, 6, 4},
             {0, 5, 6},
             {4, 6, 5}}),
        IoError);
}

TEST(GrowingMesh, SplitsInTheMiddleAndKeepsAreaAndVolumeOfFlatFaces) {
    GrowingMesh mesh = cube();
    MeshDice dice(3);
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t h = dice.half_edge(mesh);
        const Vec3 a = mesh.position[mesh.origin[h]], b = mesh.position[mesh.target(h)];
        const std::uint32_t m = split_edge(mesh, h);
        EXPECT_EQ(mesh.position[m], (a + b) / 2.0);
        EXPECT_EQ(mesh.target(h), m);
    }
    EXPECT_EQ(mesh.vertices(), 208U);
    EXPECT_EQ(mesh.faces(), 412U);
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_NEAR(measure_mesh(mesh).area, 24, 1e-10);
    EXPECT_NEAR(measure_mesh(mesh).volume, 8, 1e-10);
}

TEST(GrowingMesh, GivesTheMeanOfBothEndsToTheNewVertex) {
    GrowingMesh mesh = cube();
    const std::uint32_t a = mesh.origin[0], b = mesh.target(0);
    std::tie(mesh.thickening[a], mesh.thickening[b]) = std::tuple(2.0, 4.0);
    std::tie(mesh.travel[a], mesh.travel[b]) = std::tuple(100.0, 160.0);
    mesh.branch[a] = 7;
    const std::uint32_t m = split_edge(mesh, 0);
    EXPECT_EQ(mesh.thickening[m], 3);
    EXPECT_EQ(mesh.travel[m], 130);
    EXPECT_EQ(mesh.branch[m], 7U);
    EXPECT_EQ(mesh.tissue[m], Tissue::cambium);
    EXPECT_EQ(mesh.phloem_up[m], kNone);
}

TEST(GrowingMesh, CollapsesIntoTheOriginAndUndoesASplit) {
    GrowingMesh mesh = cube();
    const std::uint32_t a = mesh.origin[0];
    split_edge(mesh, 0);
    ASSERT_TRUE(can_collapse(mesh, 0));
    collapse_edge(mesh, 0);
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_EQ(mesh.position[a], Vec3(0, 0, 0));
    EXPECT_EQ(mesh.faces(), 12U);
    EXPECT_EQ(mesh.free_faces.size(), 2U);
    EXPECT_NEAR(measure_mesh(mesh).volume, 8, 1e-12);
    EXPECT_NEAR(measure_mesh(mesh).area, 24, 1e-12);
}

TEST(GrowingMesh, CollapsesNoEdgeOfATetrahedronAndFlipsNone) {
    const GrowingMesh mesh = tetrahedron();
    for (std::uint32_t h = 0; h < 12; ++h) {
        EXPECT_FALSE(can_collapse(mesh, h));
        EXPECT_FALSE(can_flip(mesh, h));
    }
}

// Round a neck of three edges that bound no face, the link condition fails.
TEST(GrowingMesh, KeepsANeckOpen) {
    // Two tetrahedra on the triangle 0 1 2, which is no face itself.
    const GrowingMesh mesh =
        growing_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}, {0.3, 0.3, -1}},
                     {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
    for (const std::uint32_t h : {0U, 3U, 6U})
        EXPECT_FALSE(can_collapse(mesh, h));
}

TEST(GrowingMesh, TakesTheMergedVertexOutOfItsPhloemLine) {
    GrowingMesh mesh = cube();
    const std::uint32_t a = mesh.origin[0], b = mesh.target(0);
    const std::uint32_t m = split_edge(mesh, 0);
    mesh.phloem_up[a] = m;
    mesh.phloem_down[m] = a;
    mesh.phloem_up[m] = b;
    mesh.phloem_down[b] = m;
    collapse_edge(mesh, 0);
    EXPECT_EQ(mesh.phloem_up[a], b);
    EXPECT_EQ(mesh.phloem_down[b], a);
    EXPECT_TRUE(faults(mesh).empty());
}

TEST(GrowingMesh, FlipsAndFlipsBackInFourTurns) {
    GrowingMesh mesh = cube();
    int turns = 0;
    for (std::uint32_t at = 0; at < mesh.origin.size(); ++at) {
        GrowingMesh turned = mesh;
        if (!can_flip(turned, at)) continue;
        ++turns;
        const std::uint32_t a = mesh.origin[at], b = mesh.target(at);
        flip_edge(turned, at);
        EXPECT_TRUE(faults(turned).empty());
        EXPECT_NE(turned.origin[at], a);
        for (int i = 1; i < 4; ++i)
            flip_edge(turned, at);
        EXPECT_EQ(turned.origin[at], a);
        EXPECT_EQ(turned.target(at), b);
        EXPECT_TRUE(faults(turned).empty());
    }
    EXPECT_GT(turns, 10);
}

TEST(GrowingMesh, StaysSoundThroughAnyOperations) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        GrowingMesh mesh = cube();
        MeshDice dice(seed);
        std::array<int, 4> done{};
        for (int i = 0; i < 3000; ++i) {
            ++done[random_step(mesh, dice)];
            if (i % 10 != 0) continue;
            ASSERT_TRUE(faults(mesh).empty()) << faults(mesh).front() << " after " << i;
            ASSERT_EQ(euler_number(mesh), 2);
        }
        // All kinds have come about often: the test has seen something.
        for (int kind = 0; kind < 3; ++kind)
            EXPECT_GT(done[static_cast<std::size_t>(kind)], 300);
    }
}

TEST(GrowingMesh, FindsFaults) {
    GrowingMesh open = cube();
    free_face(open, 3);
    EXPECT_FALSE(faults(open).empty());
    GrowingMesh linked = cube();
    linked.phloem_up[0] = 99;
    EXPECT_EQ(faults(linked), std::vector<std::string>{"vertex 0 has a link to nothing"});
    GrowingMesh wrong = cube();
    join_twins(wrong, 0, 4);
    EXPECT_FALSE(faults(wrong).empty());
}
