// SPDX-License-Identifier: MIT
// Trees beside and in solids that are meshes.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "support/meshes.h"
#include "surface/crossings.h"
#include "unit/surface/grown.h"
#include "unit/surface/solid_of.h"

namespace edaha {
namespace {

SurfaceParams thick_trunk(std::int64_t steps) {
    SurfaceParams params = trunk(steps);
    params.thickening_mm = 8;
    return params;
}

void expect_clear(const SurfaceGrowth& growth, const SurfaceParams& params) {
    EXPECT_GT(growth.fields().contacts(), 10U);
    EXPECT_LE(growth.fields().deepest_mm(growth.mesh()), params.merge_mm / 10);
    EXPECT_TRUE(crossing_faces(growth.mesh()).empty());
}

TEST(MeshObstacles, KeepTheTreeOutOfABox) {
    SurfaceParams params = thick_trunk(90);
    params.obstacles.push_back(
        solid_of(test::box({-300, 0, -150}, {300, 900, 150}), {0, 300, 420}));
    expect_clear(grown(params), params);
}

TEST(MeshObstacles, KeepTheTreeOutOfARock) {
    SurfaceParams params = thick_trunk(90);
    params.obstacles.push_back(solid_of(test::sphere({0, 0, 0}, 400, 7), {100, 500, 600}));
    expect_clear(grown(params), params);
}

TEST(MeshObstacles, StopItTheSameOnAnyNumberOfThreads) {
    SurfaceParams params = thick_trunk(60);
    params.obstacles.push_back(solid_of(test::torus(500, 90, 24, 12), {0, 800, 300}));
    std::vector<SurfaceGrowth> both;
    for (const std::size_t threads : {1U, 2U}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        both.push_back(grown(params));
    }
    EXPECT_GT(both[0].fields().contacts(), 10U);
    EXPECT_EQ(both[0].mesh().position, both[1].mesh().position);
    EXPECT_EQ(both[0].mesh().origin, both[1].mesh().origin);
}

TEST(MeshHollows, TakeTheSameVerticesAsTheirPrimitive) {
    SurfaceParams params = thick_trunk(41);
    SolidParams box;
    box.shape = SolidShape::box;
    box.from = {-150, 900, 100};
    box.to = {150, 1500, 500};
    box.step = 40;
    SolidParams mesh = solid_of(test::box({-150, -300, -200}, {150, 300, 200}), {0, 1200, 300});
    mesh.step = 40;
    params.hollows = {box};
    const SurfaceGrowth by_box = grown(params);
    params.hollows = {mesh};
    const SurfaceGrowth by_mesh = grown(params);
    EXPECT_EQ(by_mesh.mesh().tissue, by_box.mesh().tissue);
    EXPECT_EQ(by_mesh.mesh().position, by_box.mesh().position);
    EXPECT_GT(std::ranges::count(by_box.mesh().tissue, Tissue::xylem), 10);
}

}  // namespace
}  // namespace edaha
