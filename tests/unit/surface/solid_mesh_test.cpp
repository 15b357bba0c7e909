// SPDX-License-Identifier: MIT
#include "surface/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/keyed_random.h"
#include "support/meshes.h"
#include "surface/solids.h"
#include "unit/surface/solid_of.h"

namespace edaha {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// In a cube of side 2 `reach`.
std::vector<Vec3> places(double reach, std::uint32_t count) {
    const KeyedRandom random(0, 7, 1);
    std::vector<Vec3> all;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto number = [&](std::uint32_t axis) {
            return reach * (2 * random.uniform(i, axis) - 1);
        };
        all.emplace_back(number(0), number(1), number(2));
    }
    return all;
}

TEST(SolidMesh, ABoxIsAsFarAsTheBox) {
    const Vec3 shift(3, -20, 11);
    const Solid mesh(solid_of(test::box({-40, -30, -20}, {40, 30, 20}), shift));
    const Solid box(
        solid_of(SolidShape::box, shift - Vec3(40, 30, 20), shift + Vec3(40, 30, 20), 0));
    for (const Vec3& p : places(90, 4000))
        EXPECT_NEAR(mesh.distance(p), box.distance(p), 1e-9);
    // Right above corners, edges and the diagonals of sides.
    for (double x = -80; x <= 80; x += 40)
        for (double y = -60; y <= 60; y += 30)
            for (double z = -40; z <= 40; z += 20)
                EXPECT_NEAR(mesh.distance(shift + Vec3(x, y, z)),
                            box.distance(shift + Vec3(x, y, z)), 1e-9);
}

TEST(SolidMesh, ABallIsAsFarAsTheBall) {
    constexpr int kRings = 40;
    const Solid mesh(solid_of(test::sphere({0, 0, 0}, 100, kRings), {5, 6, 7}));
    const Solid ball(solid_of(SolidShape::ball, {5, 6, 7}, {}, 100));
    // A facet's middle is nearer to the ball's: its corners are half a facet's diagonal away.
    const double sagitta = 100 * (1 - std::cos(std::sqrt(2) * std::numbers::pi / (2 * kRings)));
    for (const Vec3& p : places(250, 4000)) {
        EXPECT_GE(mesh.distance(p), ball.distance(p) - 1e-9);
        EXPECT_LE(mesh.distance(p), ball.distance(p) + 1.01 * sagitta);
    }
    EXPECT_NEAR(glm::distance(mesh.outward({5, 250, 7}), Vec3(0, 1, 0)), 0, 1e-6);
}

TEST(SolidMesh, KnowsTheHoleOfATorus) {
    const Solid mesh(solid_of(test::torus(100, 30, 120, 60), {}));
    for (const Vec3& p : places(160, 4000)) {
        const double expected = std::hypot(std::hypot(p.x, p.z) - 100, p.y) - 30;
        EXPECT_NEAR(mesh.distance(p), expected, 0.15);
    }
}

// Where faces meet at sharp angles, the nearest face may look away.
TEST(SolidMesh, KnowsTheInsideOfANeedle) {
    Mesh mesh = test::box({}, {});
    mesh.points = {{0, 0, 0}, {10, 0, 0}, {0, 0, 10}, {3, 200, 3}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    mesh.part_of.assign(4, 0);
    const Solid needle(solid_of(mesh, {}));
    for (Vec3 p : places(25, 6000)) {
        p.y = 8 * p.y + 100;
        double out = -kInfinity;  // of the planes of its faces
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 normal = glm::normalize(
                glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
            out = std::max(out, glm::dot(p - mesh.points[a], normal));
        }
        EXPECT_EQ(needle.contains(p), out < 0);
        if (out < 0) {
            EXPECT_NEAR(needle.distance(p), out, 1e-9);
        } else {
            EXPECT_GE(needle.distance(p), out - 1e-9);
        }
    }
}

TEST(SolidMesh, PiecesCountTogether) {
    Mesh mesh = test::box({-40, -30, -20}, {10, 30, 20});
    test::add(mesh, test::box({-10, -10, -10}, {60, 10, 50}));
    test::add(mesh, test::sheet({-80, -80, -80}, {10, 0, 0}, {0, 10, 0}));  // open: nothing
    const std::vector<Solid> boxes{
        Solid(solid_of(SolidShape::box, {-40, -30, -20}, {10, 30, 20}, 0)),
        Solid(solid_of(SolidShape::box, {-10, -10, -10}, {60, 10, 50}, 0))};
    const Solid both(solid_of(mesh, {}));
    for (const Vec3& p : places(90, 4000))
        EXPECT_NEAR(both.distance(p), least_distance(boxes, 1, p), 1e-9);
}

TEST(SolidMesh, IsExactWhereItIsNearerThanEnough) {
    const SolidMesh mesh(test::sphere({0, 0, 0}, 100, 12));
    for (const Vec3& p : places(250, 1000)) {
        const double exact = mesh.distance(p, kInfinity);
        for (const double enough : {-20.0, 0.0, 30.0, 100.0}) {
            const double found = mesh.distance(p, enough);
            if (exact < enough) {
                EXPECT_EQ(found, exact) << enough;
            } else {
                EXPECT_GE(found, enough);
            }
        }
    }
}

TEST(SolidMesh, NothingIsThereWithoutAMesh) {
    const Solid nothing(solid_of(SolidShape::mesh, {}, {}, 0));
    EXPECT_EQ(nothing.distance({1, 2, 3}), kInfinity);
    EXPECT_FALSE(nothing.contains({0, 0, 0}));
}

}  // namespace
}  // namespace edaha
