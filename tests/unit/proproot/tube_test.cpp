// SPDX-License-Identifier: MIT
#include "proproot/tube.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "unit/proproot/closed.h"

namespace edaha::test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Tube, OfTwoCirclesIsACylinder) {
    Mesh mesh;
    const std::vector<TubeCircle> circles{{{1, 2, 3}, {0, 1, 0}, 5, 0},
                                          {{1, 12, 3}, {0, 1, 0}, 5, 10}};
    add_tube(mesh, {"a", 0, -1, 0, std::nullopt}, circles, {64, false, false, 10 * kPi});
    EXPECT_TRUE(parts_are_closed(mesh));
    // A prism over a regular polygon.
    const double area = 32 * 25 * std::sin(2 * kPi / 64);
    EXPECT_NEAR(volumes(mesh).at(0), area * 10, 1e-9);
}

TEST(Tube, IsCutByTheGround) {
    Mesh mesh;
    const Vec3 way = glm::normalize(Vec3(1, -1, 0));
    const std::vector<TubeCircle> circles{{{0, 10, 0}, way, 2, 0}, {{10, 0, 0}, way, 2, 14}};
    add_tube(mesh, {"a", 0, -1, 0, std::nullopt}, circles, {32, true, false, 1});
    EXPECT_TRUE(parts_are_closed(mesh));
    // The cut is an ellipse, and slants even the lengths out: the volume is that of a straight one.
    const double area = 16 * 4 * std::sin(2 * kPi / 32);
    EXPECT_NEAR(volumes(mesh).at(0), area * std::sqrt(200), 1e-9);
    double widest = 0;
    for (std::size_t i = 32; i < 64; ++i) {
        EXPECT_EQ(mesh.points[i].y, 0);
        widest = std::max(widest, std::abs(mesh.points[i].x - 10));
    }
    EXPECT_NEAR(widest, 2 * std::sqrt(2), 0.02);
}

TEST(Tube, EndsInAPoint) {
    Mesh mesh;
    const std::vector<TubeCircle> circles{{{0, 0, 0}, {0, 0, 1}, 3, 0},
                                          {{0, 0, 7}, {0, 0, 1}, 0, 7}};
    add_tube(mesh, {"a", 0, -1, 0, std::nullopt}, circles, {48, false, true, 1});
    EXPECT_TRUE(parts_are_closed(mesh));
    const double area = 24 * 9 * std::sin(2 * kPi / 48);
    EXPECT_NEAR(volumes(mesh).at(0), area * 7 / 3, 1e-9);
}

// Round a ring and back: on a circle in a plane, sides turn with the normals and nothing else.
TEST(Tube, DoesNotRoll) {
    Mesh mesh;
    std::vector<TubeCircle> circles;
    for (int i = 0; i <= 30; ++i) {
        const double angle = kPi * i / 30;
        circles.push_back({{50 * std::cos(angle), 0, 50 * std::sin(angle)},
                           {-std::sin(angle), 0, std::cos(angle)},
                           4,
                           double(i)});
    }
    add_tube(mesh, {"a", 0, -1, 0, std::nullopt}, circles, {12, false, false, 1});
    for (std::size_t ring = 1; ring <= 30; ++ring)
        for (std::size_t j = 0; j < 12; ++j)
            EXPECT_NEAR(mesh.points[ring * 12 + j].y, mesh.points[j].y, 1e-12);
}

TEST(Tube, LaysOutItsSurfaceInLengths) {
    Mesh mesh;
    const std::vector<TubeCircle> circles{{{0, 0, 0}, {0, 1, 0}, 1, -3},
                                          {{0, 8, 0}, {0, 1, 0}, 1, 5}};
    add_tube(mesh, {"a", 0, -1, 0, std::nullopt}, circles, {16, false, false, 2 * kPi});
    ASSERT_EQ(mesh.uv.size(), mesh.triangles.size());
    double least_v = 1e9, most_v = -1e9, most_u = 0;
    for (const auto& corners : mesh.uv) {
        for (const glm::dvec2 corner : corners) {
            least_v = std::min(least_v, corner.y);
            most_v = std::max(most_v, corner.y);
            most_u = std::max(most_u, corner.x);
            // No triangle runs back over the seam.
            EXPECT_LE(std::abs(corner.x - corners[0].x), 2 * kPi / 16 + 1e-12);
        }
    }
    EXPECT_EQ(least_v, -3);
    EXPECT_EQ(most_v, 5);
    EXPECT_DOUBLE_EQ(most_u, 2 * kPi);
}

}  // namespace
}  // namespace edaha::test
