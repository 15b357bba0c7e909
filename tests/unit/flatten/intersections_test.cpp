// SPDX-License-Identifier: MIT
#include "flatten/intersections.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/keyed_random.h"
#include "flatten/box_pairs.h"
#include "support/meshes.h"

namespace edaha {
namespace {

using namespace test;

std::vector<ViewSegment> crossings(const Mesh& mesh, View view) {
    view.shown = find_shown(mesh, mesh_edges(mesh), view);
    return intersect_shown(view, mesh).segments;
}

bool overlap(const TriangleBox& a, const TriangleBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

// Boxes of all sizes, many of them in one corner.
std::vector<TriangleBox> random_boxes(std::uint64_t seed, std::uint32_t count) {
    const KeyedRandom random(0, seed, 1);
    std::vector<TriangleBox> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto number = [&](std::uint32_t purpose, double most) {
            return static_cast<std::int32_t>(most * std::pow(random.uniform(i, purpose), 3));
        };
        const ViewPoint min{number(0, 1e6) - 500'000, number(1, 1e6), number(2, 1e6)};
        const ViewPoint size{number(3, 3e4), number(4, 3e5), number(5, 3e5)};
        boxes.push_back({min, {min.x + size.x, min.y + size.y, min.z + size.z}});
    }
    return boxes;
}

TEST(BoxPairs, AreThoseThatAllAgainstAllFinds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const std::vector<TriangleBox> boxes = random_boxes(seed, 1500);
        std::vector<std::array<std::uint32_t, 2>> expected;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
                if (overlap(boxes[i], boxes[j])) expected.push_back({i, j});
            }
        }
        ASSERT_GT(expected.size(), 1000U);
        auto pairs = overlapping_pairs(boxes);
        std::sort(pairs.begin(), pairs.end());
        EXPECT_EQ(pairs, expected);
    }
}

TEST(BoxPairs, OfNothingAreNone) {
    EXPECT_TRUE(overlapping_pairs({}).empty());
}

// Spheres of radius 1 whose centres are 1 apart, side by side: a circle of radius sqrt(3)/2, seen
// edge on, of which the front half lies on front triangles of both.
TEST(Intersections, OfTwoSpheresAreACircle) {
    Mesh mesh = sphere({-0.5, 0, 0}, 1, 60);
    add(mesh, sphere({0.5, 0, 0}, 1, 60));
    CameraParams camera;
    camera.azimuth_rad = 0.3;
    const View view = project(mesh, camera, 1000);
    const auto segments = crossings(mesh, view);
    ASSERT_GT(segments.size(), 50U);
    const double radius = std::sqrt(0.75) * view.steps_per_unit;
    double length = 0;
    for (const ViewSegment& s : segments) {
        const Vec3 a(s.a.x, s.a.y, s.a.z), b(s.b.x, s.b.y, s.b.z);
        EXPECT_NEAR(glm::length(a), radius, 0.01 * radius);
        length += glm::length(b - a);
    }
    EXPECT_GT(length, 0.8 * 3.14159 * radius);
    EXPECT_LT(length, 1.3 * 3.14159 * radius);
}

// A bar through a wall that faces the eye: the segments on the wall make closed rings.
TEST(Intersections, CloseToRings) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Mesh mesh = box({-4, -4, -0.1}, {4, 4, 0.1});
        const Vec3 end(0.3 * double(seed), 1, 3);
        add(mesh, prism(-end, end, 1, 3 + static_cast<int>(seed)));
        const View view = project(mesh, {}, 1000);
        std::map<std::pair<int, int>, int> degree;
        for (const ViewSegment& s : crossings(mesh, view)) {
            ++degree[{s.a.x, s.a.y}], ++degree[{s.b.x, s.b.y}];
        }
        ASSERT_FALSE(degree.empty());
        // All but the two ends where the bar's front turns to its back.
        int odd = 0;
        for (const auto& [place, count] : degree)
            odd += count % 2;
        EXPECT_LE(odd, 2) << seed;
    }
}

TEST(Intersections, NeighboursHaveNone) {
    const Mesh mesh = torus(3, 1, 40, 20);
    EXPECT_TRUE(crossings(mesh, project(mesh, {}, 500)).empty());
}

}  // namespace
}  // namespace edaha
