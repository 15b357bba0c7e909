// SPDX-License-Identifier: MIT
#include "mesh/triangulate.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace edaha {
namespace {

Vec3 doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return glm::cross(b - a, c - a);
}

// All triangles run as the polygon does and have its area together.
void expect_tiled(const std::vector<Vec3>& polygon) {
    const std::vector<Triangle> triangles = triangulate(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    Vec3 whole(0), sum(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        whole += doubled_area(polygon[0], polygon[i - 1], polygon[i]);
    for (const Triangle& t : triangles) {
        const Vec3 area = doubled_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
        EXPECT_GE(glm::dot(area, whole), 0);
        sum += area;
    }
    EXPECT_NEAR(glm::length(sum - whole), 0, 1e-9 * glm::length(whole));
}

TEST(Triangulate, a_quad_by_its_shorter_diagonal) {
    const std::vector<Vec3> kite = {{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {2, 1, 0}};
    EXPECT_EQ(triangulate(kite), (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Triangulate, a_hollow_quad_by_the_diagonal_inside) {
    expect_tiled({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
    expect_tiled({{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}});
}

TEST(Triangulate, hollow_polygons_in_any_plane) {
    const std::vector<Vec3> comb = {{0, 0, 0}, {7, 0, 0}, {7, 3, 0}, {6, 3, 0},
                                    {6, 1, 0}, {4, 1, 0}, {4, 3, 0}, {3, 3, 0},
                                    {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool mirrored : {false, true}) {
            std::vector<Vec3> turned;
            for (const Vec3& p : comb) {
                Vec3 point(0);
                point[axis] = mirrored ? -p.x : p.x;
                point[(axis + 1) % 3] = p.y;
                point[(axis + 2) % 3] = 0.25 * p.x;
                turned.push_back(point);
            }
            expect_tiled(turned);
        }
    }
}

TEST(Triangulate, a_ring_with_a_bridge_to_its_hole) {
    expect_tiled({{0, 0, 0},
                  {3, 0, 0},
                  {3, 3, 0},
                  {0, 3, 0},
                  {0, 0, 0},
                  {1, 1, 0},
                  {1, 2, 0},
                  {2, 2, 0},
                  {2, 1, 0},
                  {1, 1, 0}});
}

TEST(Triangulate, points_on_straight_sides) {
    expect_tiled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}});
}

// Stars: the distance from the middle changes as it likes.
TEST(Triangulate, any_star) {
    EXPECT_TRUE(rc::check([] {
        const auto radii =
            *rc::gen::resize(60, rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 100)));
        RC_PRE(radii.size() >= 3U);
        std::vector<Vec3> star;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const double angle =
                2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
            star.emplace_back(radii[i] * std::cos(angle), radii[i] * std::sin(angle), 5);
        }
        expect_tiled(star);
        RC_ASSERT(!testing::Test::HasFailure());
    }));
}

TEST(Triangulate, what_has_no_area_too) {
    EXPECT_EQ(triangulate(std::vector<Vec3>(7)).size(), 5U);
    EXPECT_TRUE(triangulate(std::vector<Vec3>(2)).empty());
}

}  // namespace
}  // namespace edaha
