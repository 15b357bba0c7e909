// SPDX-License-Identifier: MIT
#include "flatten/bark_strokes.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "bark_sheet.h"
#include "flatten/make_map.h"

namespace edaha {
namespace {

struct Traced {
    std::vector<BarkStroke> strokes;
    double px_per_unit = 1;
    Vec2 origin{0};
};

Traced trace(const Mesh& mesh, double spacing) {
    FlattenParams params;
    params.resolution = 400;
    StepClock clock;
    const SeenMesh seen = see_mesh(mesh, params, clock);
    Traced result;
    result.px_per_unit = seen.view.steps_per_unit / kStepsPerPx;
    result.origin = seen.view.origin / double(kStepsPerPx);
    result.strokes = trace_bark({mesh, seen.view, seen.tones, seen.rays},
                                {spacing * result.px_per_unit, spacing});
    return result;
}

double length_of(const BarkStroke& stroke) {
    double sum = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        sum += glm::distance(stroke.points[i - 1], stroke.points[i]);
    return sum;
}

TEST(TraceBark, FollowsLinesOfConstantU) {
    Mesh mesh;
    mesh.materials.push_back({"wood", {}});
    add_sheet(mesh, {0, 0}, {10, 20}, 0);
    const Traced traced = trace(mesh, 1);
    double total = 0;
    for (const BarkStroke& stroke : traced.strokes) {
        total += length_of(stroke) / traced.px_per_unit;
        for (const Vec2 p : stroke.points) {
            const double u = (p.x - traced.origin.x) / traced.px_per_unit;
            EXPECT_NEAR(u - std::floor(u), 0.5, 1e-3);
        }
    }
    // Ten lines of 20, less the gaps between dashes.
    EXPECT_LT(total, 200);
    EXPECT_GT(total, 120);
}

TEST(TraceBark, StopsAtWhatHidesIt) {
    Mesh mesh;
    mesh.materials.push_back({"wood", {}});
    mesh.materials.push_back({"leaf", {}});
    add_sheet(mesh, {0, 0}, {10, 20}, 0);
    add_sheet(mesh, {-1, 8}, {11, 12}, 2);
    mesh.parts[1].material = 1;  // has none of its own
    const Traced traced = trace(mesh, 1);
    std::size_t near = 0;
    for (const BarkStroke& stroke : traced.strokes) {
        for (const Vec2 p : stroke.points) {
            const double y = -(p.y - traced.origin.y) / traced.px_per_unit;
            EXPECT_TRUE(y < 8.05 || y > 11.95) << y;
            if (std::abs(y - 8) < 0.1 || std::abs(y - 12) < 0.1) ++near;
        }
    }
    EXPECT_GT(near, 5U);  // some come right up to it
}

TEST(TraceBark, LeavesOutWhatWouldCrowd) {
    Mesh mesh;
    mesh.materials.push_back({"wood", {}});
    add_sheet(mesh, {0, 0}, {10, 20}, 0);
    for (auto& uv : mesh.uv) {
        for (auto& corner : uv)
            corner.x *= 4;  // lines four times as close
    }
    EXPECT_TRUE(trace(mesh, 1).strokes.empty());
}

TEST(TraceBark, NeedsPlacesOnTheSurface) {
    Mesh mesh;
    mesh.materials.push_back({"wood", {}});
    add_sheet(mesh, {0, 0}, {10, 20}, 0);
    mesh.uv.clear();
    EXPECT_TRUE(trace(mesh, 1).strokes.empty());
}

}  // namespace
}  // namespace edaha
