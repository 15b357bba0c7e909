// SPDX-License-Identifier: MIT
#include "flatten/smooth_line.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "unit/flatten/painter_scene.h"

namespace edaha {
namespace {

std::vector<Vec2> closed(std::vector<Vec2> points) {
    points.push_back(points.front());
    return points;
}

// Distances of the curve's points from a circle round the origin.
double worst_radius(const std::vector<CurvePiece>& pieces, double radius) {
    double worst = 0;
    for (const CurvePiece& piece : pieces) {
        for (int i = 0; i <= 20; ++i)
            worst = std::max(worst, std::abs(glm::length(eval(piece.curve, i / 20.0)) - radius));
    }
    return worst;
}

// The sharpest turn where two pieces meet, as 1 - cosine; the seam of a closed line included.
double sharpest_joint(const std::vector<CurvePiece>& pieces, bool seam) {
    double worst = 0;
    for (std::size_t i = seam ? 0 : 1; i < pieces.size(); ++i) {
        const Cubic& a = pieces[(i + pieces.size() - 1) % pieces.size()].curve;
        const Cubic& b = pieces[i].curve;
        EXPECT_EQ(a.p3, b.p0);
        worst =
            std::max(worst, 1 - glm::dot(glm::normalize(a.p3 - a.p2), glm::normalize(b.p1 - b.p0)));
    }
    return worst;
}

TEST(SmoothLine, MakesFewCubicsOfACircleOfSmallEdges) {
    for (const double radius : {4.0, 20.0, 300.0}) {
        const int corners = static_cast<int>(8 * std::sqrt(radius)) + 8;
        const auto points = closed(scenes::ellipse({0, 0}, {radius, radius}, corners));
        const std::vector<CurvePiece> pieces = smooth_line(points, true, {});
        EXPECT_LE(pieces.size(), 8U) << radius;
        EXPECT_LE(worst_radius(pieces, radius), 0.6) << radius;
        EXPECT_LT(sharpest_joint(pieces, true), 1e-6) << radius;
        EXPECT_EQ(std::count_if(pieces.begin(), pieces.end(),
                                [](const CurvePiece& p) { return p.straight; }),
                  0);
    }
}

TEST(SmoothLine, KeepsCornersAndLongEdges) {
    const auto points = closed(scenes::rectangle({0, 0}, {40, 5}));
    const std::vector<CurvePiece> pieces = smooth_line(points, true, {});
    ASSERT_EQ(pieces.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(pieces[i].straight);
        EXPECT_EQ(pieces[i].curve.p0, points[i]);
    }
    EXPECT_EQ(pieces.back().end, 90);
}

TEST(SmoothLine, SeesOneLineInManyPointsWithNoise) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 400; ++i)
        points.push_back({i * 0.5, (i % 3 - 1) / 2048.0});
    const std::vector<CurvePiece> pieces = smooth_line(points, false, {});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_TRUE(pieces[0].straight);
}

TEST(SmoothLine, GoesThroughZigzagsOfHalfAPixel) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 100; ++i) {
        const double angle = i * 0.01, radius = 80 + (i % 2) * 0.3;
        points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    const std::vector<CurvePiece> pieces = smooth_line(points, false, {});
    EXPECT_LE(pieces.size(), 4U);
    EXPECT_LT(sharpest_joint(pieces, false), 1e-6);
    EXPECT_LE(worst_radius(pieces, 80.15), 0.7);
}

TEST(SmoothLine, JoinsStraightSidesAndRoundEndsSmoothly) {
    // A stadium: two sides of 60, two half circles of radius 6 in small edges.
    std::vector<Vec2> points;
    for (const double side : {1.0, -1.0}) {
        for (int i = 0; i <= 16; ++i) {
            const double angle = (i / 16.0 - 0.5) * 3.14159265358979;
            points.push_back(side * Vec2(30 + 6 * std::cos(angle), 6 * std::sin(angle)));
        }
    }
    const std::vector<CurvePiece> pieces = smooth_line(closed(points), true, {});
    const auto lines =
        std::count_if(pieces.begin(), pieces.end(), [](const CurvePiece& p) { return p.straight; });
    EXPECT_EQ(lines, 2);
    EXPECT_LE(pieces.size(), 8U);
    EXPECT_LT(sharpest_joint(pieces, true), 1e-3);
}

TEST(SmoothLine, KeepsAllVerticesOfFacets) {
    const auto points = closed(scenes::ellipse({0, 0}, {20, 20}, 16));
    SmoothParams params;
    params.straight = true;
    EXPECT_EQ(smooth_line(points, true, params).size(), 16U);
}

}  // namespace
}  // namespace edaha
