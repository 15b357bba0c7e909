// SPDX-License-Identifier: MIT
#include "flatten/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace edaha {
namespace {

using namespace test;

CameraParams looking(double azimuth_rad, double elevation_rad, Projection projection) {
    CameraParams camera;
    camera.projection = projection;
    camera.azimuth_rad = azimuth_rad;
    camera.elevation_rad = elevation_rad;
    return camera;
}

// A point for each axis, and the origin.
Mesh axes() {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return mesh;
}

Vec2 from_origin(const View& view, std::size_t point) {
    const Vec2 d = to_vec(on_screen(view.at[point])) - to_vec(on_screen(view.at[0]));
    return d / view.steps_per_unit;
}

void expect_near(Vec2 a, Vec2 b) {
    EXPECT_NEAR(a.x, b.x, 1e-5);
    EXPECT_NEAR(a.y, b.y, 1e-5);
}

TEST(View, LooksFromTheFront) {
    const View view = project(axes(), looking(0, 0, Projection::orthographic), 1000);
    expect_near(from_origin(view, 1), {1, 0});
    expect_near(from_origin(view, 2), {0, -1});
    expect_near(from_origin(view, 3), {0, 0});
    EXPECT_LT(view.at[3].z, view.at[0].z);
}

TEST(View, TheEyeWalksToTheRight) {
    const View view =
        project(axes(), looking(std::numbers::pi / 2, 0, Projection::orthographic), 1000);
    expect_near(from_origin(view, 1), {0, 0});
    expect_near(from_origin(view, 3), {-1, 0});
    EXPECT_LT(view.at[1].z, view.at[0].z);
}

TEST(View, FromAboveTheFrontIsLow) {
    const View view =
        project(axes(), looking(0, std::numbers::pi / 2, Projection::orthographic), 1000);
    expect_near(from_origin(view, 3), {0, 1});
    EXPECT_LT(view.at[2].z, view.at[0].z);
}

TEST(View, TheLongerSideHasTheResolution) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const Mesh mesh = random_prisms(3, 30);
        const View view = project(mesh, looking(0.4, 0.2, projection), 700);
        const auto [x0, x1] = std::minmax_element(view.at.begin(), view.at.end(),
                                                  [](auto& a, auto& b) { return a.x < b.x; });
        const auto [y0, y1] = std::minmax_element(view.at.begin(), view.at.end(),
                                                  [](auto& a, auto& b) { return a.y < b.y; });
        EXPECT_NEAR(std::max(x1->x - x0->x, y1->y - y0->y), 700 * kStepsPerPx, 2);
    }
}

TEST(View, TellsWhereTheWorldsOriginIs) {
    Mesh mesh = axes();
    mesh.points.push_back({-3, 2, 5});
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const View view = project(mesh, looking(0.3, 0.5, projection), 1000);
        const Vec2 seen = to_vec(on_screen(view.at[0]));
        EXPECT_NEAR(seen.x, view.origin.x, 0.51);
        EXPECT_NEAR(seen.y, view.origin.y, 0.51);
    }
}

TEST(View, PerspectiveKeepsLinesStraightInDepthToo) {
    Mesh mesh;
    const Vec3 a(-2, 1, 3), b(4, -1, -5);
    for (int i = 0; i <= 8; ++i)
        mesh.points.push_back(a + (b - a) * (i / 8.0));
    mesh.points.push_back({0, 3, 0});
    const View view = project(mesh, looking(0.5, 0.3, Projection::perspective), 1000);
    const ViewPoint p = view.at[0], q = view.at[8];
    for (std::size_t i = 1; i < 8; ++i) {
        const double t = (view.at[i].x - double(p.x)) / (double(q.x) - p.x);
        EXPECT_NEAR(view.at[i].y, p.y + t * (double(q.y) - p.y), 3);
        EXPECT_NEAR(view.at[i].z, p.z + t * (double(q.z) - p.z), 6);
    }
}

TEST(View, WhatIsNearerLooksLargerInPerspective) {
    Mesh mesh;
    mesh.points = {{-1, 0, 2}, {1, 0, 2}, {-1, 0, -2}, {1, 0, -2}, {0, 3, 0}, {0, -3, 0}};
    const View view = project(mesh, looking(0, 0, Projection::perspective), 1000);
    EXPECT_GT(view.at[1].x - view.at[0].x, 1.2 * (view.at[3].x - view.at[2].x));
}

TEST(View, AllOfTheMeshIsWithinTheFieldOfView) {
    const Mesh mesh = random_prisms(5, 30);
    CameraParams camera = looking(0.4, 0.2, Projection::perspective);
    camera.field_of_view_rad = 2;
    for (const ViewPoint p : project(mesh, camera, 1000).at)
        EXPECT_LE(std::abs(p.z), 1 << 24);
}

// Every triangle's outside or inside is seen, by the sign of its normal against the eye.
TEST(View, FrontIsWhatTurnsToTheEye) {
    const Mesh mesh = sphere({1, 2, 3}, 2, 12);
    const View view = project(mesh, looking(0.3, 0.4, Projection::orthographic), 1000);
    std::size_t fronts = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const Vec3 normal =
            glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
        const double towards = glm::dot(normal, view.to_eye);
        if (std::abs(towards) > 1e-3) {
            EXPECT_EQ(view.front[i] != 0, towards > 0);
        }
        fronts += view.front[i];
    }
    EXPECT_NEAR(double(fronts), double(mesh.triangles.size()) / 2, 12);
}

}  // namespace
}  // namespace edaha
