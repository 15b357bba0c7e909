// SPDX-License-Identifier: MIT
#include "flatten/intersections.h"

#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "flatten/box_pairs.h"
#include "meshes.h"

namespace edaha {
namespace {

using namespace test;

std::vector<ViewSegment> crossings(const Mesh& mesh, View view) {
    view.shown = find_shown(mesh, mesh_edges(mesh), view);
    return intersect_shown(view, mesh);
}

TEST(BoxPairs, AreThoseThatAllAgainstAllFinds) {
    const Mesh mesh = random_prisms(1, 40);
    std::vector<ViewBox> boxes;
    for (const Triangle& t : mesh.triangles) {
        ViewBox box{{1e9F, 1e9F, 1e9F}, {-1e9F, -1e9F, -1e9F}};
        for (const std::uint32_t p : t) {
            for (int k = 0; k < 3; ++k) {
                const auto i = static_cast<std::size_t>(k);
                box.min[i] = std::min(box.min[i], static_cast<float>(mesh.points[p][k]));
                box.max[i] = std::max(box.max[i], static_cast<float>(mesh.points[p][k]));
            }
        }
        boxes.push_back(box);
    }
    std::vector<std::array<std::uint32_t, 2>> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            bool overlap = true;
            for (std::size_t k = 0; k < 3; ++k)
                overlap = overlap && boxes[i].min[k] <= boxes[j].max[k] &&
                          boxes[j].min[k] <= boxes[i].max[k];
            if (overlap) expected.push_back({i, j});
        }
    }
    auto pairs = overlapping_pairs(boxes);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, expected);
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
