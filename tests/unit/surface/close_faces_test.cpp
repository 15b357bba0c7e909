// SPDX-License-Identifier: MIT
#include "surface/close_faces.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/keyed_random.h"
#include "surface/crossings.h"
#include "surface/move.h"

using namespace edaha;

namespace {

// Two faces that share `shared` corners, with random corners and ways.
struct TwoFaces {
    GrowingMesh mesh;
    std::vector<Vec3> growth, slides;

    TwoFaces(const KeyedRandom& random, std::uint32_t key, std::uint32_t shared) {
        std::uint32_t index = 0;
        const auto vector = [&](double size) {
            const auto number = [&] { return random.uniform(key, 1, index++) - 0.5; };
            const double x = number(), y = number(), z = number();
            return size * Vec3(x, y, z);
        };
        const double speed = 40 * random.uniform(key, 2, 0);
        for (std::uint32_t v = 0; v < 6 - shared; ++v) {
            new_vertex(mesh);
            mesh.position[v] = vector(200) + (v < 3 ? Vec3(0) : Vec3(70, 0, 0));
            growth.push_back(vector(speed));
            slides.push_back(vector(speed / 4));
        }
        new_face(mesh, 0, 1, 2);
        if (shared == 0) new_face(mesh, 3, 4, 5);
        if (shared == 1) new_face(mesh, 2, 3, 4);
        if (shared == 2) new_face(mesh, 2, 1, 3);
    }
    double clear() const {
        const std::vector<Vec3> normals = face_normals(mesh);
        return clear_steps(mesh, {normals, {}, growth, slides}, {0, 1}, 100);
    }
    // Whether they pass through each other once all corners have gone parts of that many steps.
    bool cross(const KeyedRandom& random, std::uint32_t key, double steps) const {
        GrowingMesh moved = mesh;
        for (std::uint32_t v = 0; v < growth.size(); ++v) {
            moved.position[v] += steps * random.uniform(key, 3, v) * growth[v];
            moved.position[v] += steps * random.uniform(key, 4, v) * slides[v];
        }
        return triangles_cross(corners_of(moved, 0), corners_of(moved, 1));
    }
};

}  // namespace

TEST(ClearSteps, AreNeverTooMany) {
    const KeyedRandom random(7, 8, 9);
    int clear = 0, crossing = 0;
    for (std::uint32_t shared = 0; shared < 2; ++shared) {
        for (std::uint32_t i = 0; i < 3000; ++i) {
            const TwoFaces faces(random, 10 * i + shared, shared);
            const double steps = faces.clear();
            if (steps == 0) continue;
            clear += steps >= 1;
            for (std::uint32_t k = 0; k < 30; ++k) {
                EXPECT_FALSE(faces.cross(random, 1000 * i + k, 0.999 * std::min(steps, 100.0)))
                    << shared << " " << i;
                crossing += faces.cross(random, 1000 * i + k, 2 * steps + 1);
            }
        }
    }
    EXPECT_GT(clear, 1000);
    EXPECT_GT(crossing, 1000);
}

// What is found falls short of the truth, but not by much: faces that stand still and do not cross
// are told apart nearly always.
TEST(ClearSteps, AreFoundForNearlyAllThatAreApart) {
    const KeyedRandom random(1, 8, 9);
    int apart = 0, told = 0;
    for (std::uint32_t i = 0; i < 6000; ++i) {
        const TwoFaces faces(random, i, i % 2);
        if (faces.cross(random, i, 0)) continue;
        ++apart;
        told += faces.clear() > 0;
    }
    EXPECT_GT(told, 0.93 * apart) << told << " of " << apart;
}

TEST(ClearSteps, AreWithoutEndAtACommonEdge) {
    const KeyedRandom random(1, 1, 1);
    for (std::uint32_t i = 0; i < 20; ++i)
        EXPECT_TRUE(std::isinf(TwoFaces(random, i, 2).clear()));
}

TEST(StepsOfRest, AreThoseThatTheGapLasts) {
    const RestParams params{5, 35};
    EXPECT_EQ(steps_of_rest(35, 2, params), 5);
    EXPECT_EQ(steps_of_rest(6.9, 2, params), 0);
    EXPECT_EQ(steps_of_rest(-3, 2, params), 0);
    EXPECT_LE(steps_of_rest(1e9, 0, params), 20);
}
