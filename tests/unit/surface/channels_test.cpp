// SPDX-License-Identifier: MIT
#include "surface/channels.h"

#include <numbers>

#include <gtest/gtest.h>

#include "base/stable_math.h"
#include "block_meshes.h"

using namespace edaha;

namespace {

// A ring of three-sided section, as wood or, inside out, as air; and a block beside it.
GrowingMesh ring_and_block(bool is_air) {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    constexpr std::uint32_t kRound = 12;
    for (std::uint32_t i = 0; i < kRound; ++i) {
        const auto [sine, cosine] = stable::sin_cos(2 * std::numbers::pi * i / kRound);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const auto [up, out] = stable::sin_cos(2 * std::numbers::pi * k / 3);
            const double r = 200 + 30 * out;
            points.emplace_back(r * cosine, 1000 + 30 * up, r * sine);
            const std::uint32_t a = 3 * i + k, b = 3 * i + (k + 1) % 3;
            const std::uint32_t c = (a + 3) % (3 * kRound), d = (b + 3) % (3 * kRound);
            for (const Triangle& t : {Triangle{a, b, c}, Triangle{c, b, d}})
                triangles.push_back(is_air ? Triangle{t[0], t[2], t[1]} : t);
        }
    }
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Vec3& p :
         {Vec3(900, 900, 0), Vec3(999, 900, 0), Vec3(900, 999, 0), Vec3(900, 900, 99)})
        points.push_back(p);
    for (const Triangle& t : {Triangle{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
    return growing_mesh(points, triangles);
}

std::uint32_t edge(const GrowingMesh& mesh, std::uint32_t a, std::uint32_t b) {
    std::uint32_t found = kNone;
    mesh.for_each_out(a, [&](std::uint32_t h) {
        if (mesh.target(h) == b) found = h;
    });
    return found;
}

}  // namespace

TEST(CutCycle, TakesAHandleAway) {
    GrowingMesh mesh = ring_and_block(false);
    ASSERT_EQ(euler_number_of(mesh), 0 + 2);
    const double volume = volume_of(mesh);
    ASSERT_GT(volume, 0);
    cut_cycle(mesh, edge(mesh, 0, 1), edge(mesh, 1, 2), edge(mesh, 2, 0));
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_EQ(euler_number_of(mesh), 2 + 2);
    EXPECT_NEAR(volume_of(mesh), volume, 1e-9 * volume);
}

TEST(CutCycle, EndsPhloemThatRanAcross) {
    GrowingMesh mesh = ring_and_block(false);
    for (std::uint32_t v = 0; v < 30; ++v) {
        mesh.phloem_up[v] = v + 3;
        mesh.phloem_down[v + 3] = v;
    }
    cut_cycle(mesh, edge(mesh, 3, 4), edge(mesh, 4, 5), edge(mesh, 5, 3));
    EXPECT_TRUE(faults(mesh).empty());
    for (std::uint32_t v = 0; v < mesh.out.size(); ++v) {
        if (mesh.phloem_up[v] == kNone) continue;
        EXPECT_NE(edge(mesh, v, mesh.phloem_up[v]), kNone) << v;
    }
}

TEST(CloseChannels, LeavesThinWood) {
    GrowingMesh mesh = ring_and_block(false);
    EXPECT_EQ(close_channels(mesh, {70, 2000}).cut, 0U);
    EXPECT_EQ(mesh.vertices(), 40U);
}

TEST(CloseChannels, TakesAirOutOnceItIsABubble) {
    GrowingMesh mesh = ring_and_block(true);
    const Channels channels = close_channels(mesh, {70, 2000});
    EXPECT_GE(channels.cut, 1U);
    EXPECT_GE(channels.bubbles, 1U);
    EXPECT_TRUE(faults(mesh).empty());
    EXPECT_EQ(mesh.vertices(), 4U);
    EXPECT_GT(volume_of(mesh), 0);
}

TEST(CloseChannels, LeavesWideOnes) {
    GrowingMesh mesh = ring_and_block(true);
    EXPECT_EQ(close_channels(mesh, {20, 2000}).cut, 0U);
}
