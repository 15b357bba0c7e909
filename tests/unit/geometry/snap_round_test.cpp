// SPDX-License-Identifier: MIT
#include "geometry/snap_round.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "map_oracles.h"
#include "shapes.h"

namespace edaha {
namespace {

using Segments = std::vector<GridSegment>;

TEST(SnapRound, NothingGivesNothing) {
    const Arrangement result = snap_round(Segments{});
    EXPECT_TRUE(result.nodes.empty());
    EXPECT_TRUE(result.edges.empty());
}

TEST(SnapRound, ACrossMeetsInTheMiddle) {
    const Arrangement result = snap_round(Segments{{{0, 0}, {10, 10}}, {{0, 10}, {10, 0}}});
    EXPECT_EQ(result.nodes.size(), 5u);
    EXPECT_EQ(result.edges.size(), 4u);
    EXPECT_EQ(result.nodes[2], (GridPoint{5, 5}));
}

TEST(SnapRound, CrossingsRoundHalvesUpwards) {
    // At (1/2, 1/2) and at (-1/2, -1/2).
    EXPECT_EQ(snap_round(Segments{{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}}).nodes.size(), 4u);
    const Arrangement low = snap_round(Segments{{{-2, -2}, {1, 1}}, {{-3, 2}, {2, -3}}});
    EXPECT_NE(std::find(low.nodes.begin(), low.nodes.end(), GridPoint{0, 0}), low.nodes.end());
}

TEST(SnapRound, CrossingsJustBesideAHalfAreDecidedExactly) {
    const int n = 1000000;  // they cross at x = -1 - n / (2 n + 1), a hair right of -3/2
    const Arrangement result = snap_round(Segments{{{0, 0}, {-10, 0}}, {{-1, -n}, {-2, n + 1}}});
    ASSERT_EQ(result.nodes.size(), 5u);
    EXPECT_NE(std::find(result.nodes.begin(), result.nodes.end(), GridPoint{-1, 0}),
              result.nodes.end());
}

TEST(SnapRound, FarCrossingsAreExact) {
    // They cross in (0, 0) exactly; 2^56 doesn't fit a double's 53 bits with the products.
    const std::int32_t far = kGridLimit - 1;
    const Arrangement result = snap_round(
        Segments{{{-far, -far + 2}, {far, far - 2}}, {{-far, far - 5}, {far, -far + 5}}});
    ASSERT_EQ(result.nodes.size(), 5u);
    EXPECT_EQ(result.nodes[2], (GridPoint{0, 0}));
}

TEST(SnapRound, CoincidentSegmentsAreOneEdgeWithTheirUses) {
    const Arrangement result =
        snap_round(Segments{{{0, 0}, {10, 0}}, {{7, 0}, {3, 0}}, {{0, 0}, {10, 0}}});
    ASSERT_EQ(result.edges.size(), 3u);
    const auto uses = result.uses_of(1);
    ASSERT_EQ(uses.size(), 3u);
    EXPECT_TRUE(uses[0].forward);
    EXPECT_FALSE(uses[1].forward);
    EXPECT_EQ(uses[2].segment, 2u);
    EXPECT_EQ(result.uses_of(0).size(), 2u);
}

TEST(SnapRound, AnEndOnASegmentDividesIt) {
    const Arrangement result = snap_round(Segments{{{0, 0}, {10, 5}}, {{4, 2}, {4, 9}}});
    EXPECT_EQ(result.edges.size(), 3u);
}

TEST(SnapRound, APointOfNoLengthDividesToo) {
    const Arrangement result = snap_round(Segments{{{0, 0}, {10, 0}}, {{4, 0}, {4, 0}}});
    EXPECT_EQ(result.edges.size(), 2u);
}

TEST(SnapRound, DenseSoupsTouchOnlyInNodes) {
    for (const int side : {6, 30, 1000}) {  // from all overlapping to sparse
        const Segments soup = oracles::random_soup(100, side, 7);
        const Arrangement result = snap_round(soup);
        EXPECT_TRUE(oracles::touch_only_in_nodes(result)) << side;
    }
}

TEST(SnapRound, NothingMovesFurtherThanHalfADiagonal) {
    const Segments soup = oracles::random_soup(150, 200, 3);
    const Arrangement result = snap_round(soup);
    for (std::size_t e = 0; e < result.edges.size(); ++e) {
        for (const EdgeUse& use : result.uses_of(e)) {
            const GridSegment& s = soup[use.segment];
            for (const std::uint32_t node : {result.edges[e].from, result.edges[e].to}) {
                const GridVector d = s.b - s.a;
                const double off = static_cast<double>(orientation(s.a, s.b, result.nodes[node]));
                EXPECT_LE(std::abs(off), std::sqrt(0.5 * static_cast<double>(dot(d, d))) + 1e-9);
            }
        }
    }
}

TEST(SnapRound, UsesOfASegmentLeadFromItsStartToItsEnd) {
    const Segments soup = oracles::random_soup(200, 60, 5);
    const Arrangement result = snap_round(soup);
    std::vector<GridVector> sums(soup.size());
    for (std::size_t e = 0; e < result.edges.size(); ++e) {
        const GridVector d = result.nodes[result.edges[e].to] - result.nodes[result.edges[e].from];
        for (const EdgeUse& use : result.uses_of(e)) {
            sums[use.segment].x += use.forward ? d.x : -d.x;
            sums[use.segment].y += use.forward ? d.y : -d.y;
        }
    }
    for (std::size_t i = 0; i < soup.size(); ++i) {
        EXPECT_EQ(sums[i].x, soup[i].b.x - soup[i].a.x);
        EXPECT_EQ(sums[i].y, soup[i].b.y - soup[i].a.y);
    }
}

TEST(SnapRound, ABundleOfNearlyCoincidentSegmentsIsNoTrap) {
    Segments bundle;
    for (int i = 0; i < 400; ++i)
        bundle.push_back({{0, i % 7}, {100000, 50000 + i % 11}});
    const Arrangement result = snap_round(bundle);
    EXPECT_TRUE(oracles::touch_only_in_nodes(result));
}

}  // namespace
}  // namespace edaha
