// SPDX-License-Identifier: MIT
#include "flatten/grow_ring.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "geometry/measure.h"
#include "geometry/walk_path.h"
#include "unit/flatten/painter_scene.h"

namespace edaha {
namespace {

// Positive area: the inside is on the left where y points up, as in rings of regions.
std::vector<GrownPiece> ring_of(const std::vector<Vec2>& corners, double by) {
    std::vector<GrownPiece> ring;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 next = corners[(i + 1) % corners.size()];
        ring.push_back({{line_cubic(corners[i], next), true, 0}, by});
    }
    return ring;
}

double area(const std::vector<CurvePiece>& pieces) {
    double sum = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        sum += swept_area(pieces[i].curve);
        const Vec2 a = pieces[i].curve.p3, b = pieces[(i + 1) % pieces.size()].curve.p0;
        sum += (a.x * b.y - a.y * b.x) / 2;  // closed by a straight way, if by any
    }
    return sum;
}

const std::vector<Vec2> kSquare = scenes::rectangle({0, 0}, {10, 10});

TEST(GrowRing, GrowsASquareOnAllSides) {
    const std::vector<CurvePiece> grown = grow_ring(ring_of(kSquare, 0.5));
    ASSERT_EQ(grown.size(), 4U);
    EXPECT_NEAR(area(grown), 121, 1e-9);
    EXPECT_EQ(grown[0].curve.p0, Vec2(-0.5, -0.5));
}

TEST(GrowRing, GrowsOneSideWithSquareEnds) {
    std::vector<GrownPiece> ring = ring_of(kSquare, 0);
    ring[1].by = 0.5;
    ring[1].start = ring[1].end = GrownEnd::butt;
    const std::vector<CurvePiece> grown = grow_ring(ring);
    EXPECT_NEAR(area(grown), 105, 1e-9);
    for (std::size_t i = 1; i < grown.size(); ++i)
        EXPECT_EQ(grown[i].curve.p0, grown[i - 1].curve.p3);
}

TEST(GrowRing, ShrinksASquare) {
    const std::vector<CurvePiece> shrunk = grow_ring(ring_of(kSquare, -0.5));
    ASSERT_EQ(shrunk.size(), 4U);
    EXPECT_NEAR(area(shrunk), 81, 1e-9);
    EXPECT_EQ(shrunk[0].curve.p0, Vec2(0.5, 0.5));
}

TEST(GrowRing, DrawsOneSideInBesideOneThatGrows) {
    std::vector<GrownPiece> ring = ring_of(kSquare, 0);
    ring[1].by = -0.5, ring[2].by = 0.5;
    ring[1].start = ring[1].end = ring[2].start = ring[2].end = GrownEnd::butt;
    EXPECT_NEAR(area(grow_ring(ring)), 100, 1e-9);
}

TEST(GrowRing, LetsOneSideTaperToItsOwnEnds) {
    std::vector<GrownPiece> ring = ring_of(kSquare, 0);
    // One side in two halves: the first tapers at its start, the second at its end.
    const Vec2 middle(10, 5);
    ring[1] = {{line_cubic({10, 0}, middle), true, 0}, 0.5, GrownEnd::taper, GrownEnd::open};
    ring.insert(ring.begin() + 2,
                {{line_cubic(middle, {10, 10}), true, 0}, 0.5, GrownEnd::open, GrownEnd::taper});
    const std::vector<CurvePiece> grown = grow_ring(ring);
    EXPECT_NEAR(area(grown), 102.5, 1e-9);
    EXPECT_EQ(grown.size(), 5U);
}

TEST(GrowRing, KeepsItsDistanceFromACircle) {
    std::vector<GrownPiece> ring;
    const double arm = 0.5522847498 * 10;
    const Vec2 at[] = {{10, 0}, {0, 10}, {-10, 0}, {0, -10}};
    const Vec2 way[] = {{0, arm}, {-arm, 0}, {0, -arm}, {arm, 0}};
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        ring.push_back({{{at[i], at[i] + way[i], at[j] - way[j], at[j]}, false, 0}, 0.4});
    }
    for (const CurvePiece& piece : grow_ring(ring)) {
        for (int i = 0; i <= 20; ++i)
            EXPECT_NEAR(glm::length(eval(piece.curve, i / 20.0)), 10.4, 0.01);
    }
}

TEST(GrowRing, LimitsSpikes) {
    const std::vector<CurvePiece> grown = grow_ring(ring_of({{0, 0}, {100, -1}, {100, 1}}, 0.5));
    for (const CurvePiece& piece : grown)
        EXPECT_GT(piece.curve.p0.x, -1.01);
}

}  // namespace
}  // namespace edaha
