// SPDX-License-Identifier: MIT
// Flat drawings from mesh to pixels: our SVG, drawn by librsvg, against a depth buffer.
#include "flatten/flatten.h"

#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/flat_judge.h"
#include "support/meshes.h"

namespace edaha {
namespace {

using namespace test;

FlattenParams params_of(FlatLook look) {
    FlattenParams params;
    params.look = look;
    params.resolution = kSize - 20;
    params.size_mm = 200;
    params.camera = {Projection::orthographic, 0.4, 0.3, 0.6};
    return params;
}

Mesh smooth_scene() {
    Mesh mesh = torus(3, 1, 64, 32);
    add(mesh, sphere({1, 1.5, 0}, 2, 24));
    add(mesh, sphere({-1, 0.5, 1}, 2, 24));
    add(mesh, prism({-4, -3, -1}, {4, 4, 2}, 0.4, 24));
    return mesh;
}

// Facets keep their edges, so all that may differ is what is below the smallest area.
TEST(Flatten, FacetsAreWhatADepthBufferSees) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        FlattenParams params = params_of(FlatLook::fills_lines);
        params.smoothing_px = 0;
        const Judgement judgement = judge(random_prisms(seed, 60), params);
        EXPECT_EQ(judgement.breaches, std::vector<std::string>{});
        const Disagreement& d = judgement.labels;
        EXPECT_LE(double(d.differ), 0.002 * double(d.covered)) << seed;
        EXPECT_EQ(d.very_far, 0U) << seed;
    }
}

TEST(Flatten, CurvesStayWithinTheirTolerance) {
    const FlattenParams params = params_of(FlatLook::fills_lines);
    const Judgement judgement = judge(smooth_scene(), params);
    EXPECT_EQ(judgement.breaches, std::vector<std::string>{});
    const Disagreement& d = judgement.labels;
    EXPECT_LE(double(d.differ), 0.005 * double(d.covered));
    EXPECT_EQ(d.far, 0U);
}

// No seam of antialiasing shows the paper, between facets or between curves.
TEST(Flatten, NothingLeaks) {
    for (const double smoothing_px : {0.0, 0.5}) {
        FlattenParams params = params_of(FlatLook::fills);
        params.smoothing_px = smoothing_px;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Mesh mesh = before_a_wall(random_prisms(seed, 60), params.camera);
            EXPECT_EQ(judge(mesh, params).red, 0U) << seed << ", " << smoothing_px;
        }
    }
}

// Without traps it would: the oracle sees that.
TEST(Flatten, SeamsWouldBeNoticed) {
    FlattenParams params = params_of(FlatLook::fills);
    params.trap_mm = 0;
    const Mesh mesh = with_materials(before_a_wall(random_prisms(1, 60), params.camera));
    const View view = project(mesh, params.camera, params.resolution);
    Flattened flat = flatten(mesh, params, inks_of(mesh));
    EXPECT_GT(count_red(rendered(on_square_page(std::move(flat), view, params), true)), 1000U);
}

FlattenParams lines() {
    FlattenParams params = params_of(FlatLook::lines);
    params.smoothing_px = 0;
    params.min_line_mm = 0;
    return params;
}

double percentile(const std::vector<double>& ascending, double share) {
    return ascending.at(static_cast<std::size_t>(share * double(ascending.size() - 1)));
}

// Edges of pixels are half of one off; what is smaller than two square pixels joins a neighbour.
TEST(Flatten, StrokesLieWhereADepthBufferHasEdgesAndNowhereElse) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const StrokeDistances d = stroke_distances(random_prisms(seed, 60), lines(), "");
        EXPECT_LT(percentile(d.of_strokes, 0.95), 0.75) << seed;
        EXPECT_LT(d.of_strokes.back(), 3) << seed;
        EXPECT_LT(percentile(d.of_edges, 0.95), 0.75) << seed;
        EXPECT_LT(d.of_edges.back(), 3) << seed;
    }
}

TEST(Flatten, MissingStrokesAreNoticed) {
    const StrokeDistances d = stroke_distances(random_prisms(1, 60), lines(), "Contours");
    EXPECT_EQ(d.of_edges.back(), 8);
}

// The oracle sees a fault: a picture without one of its parts.
TEST(Flatten, AMissingPartIsNoticed) {
    const Mesh mesh = with_materials(smooth_scene());
    const FlattenParams params = params_of(FlatLook::fills);
    const View view = project(mesh, params.camera, params.resolution);
    Mesh less = mesh;
    for (std::size_t i = 0; i < less.part_of.size(); ++i) {
        if (less.part_of[i] == 1) less.triangles[i] = {0, 0, 0};
    }
    const Disagreement d = compare(paint_depth(mesh, view, kSize), fine_truth(mesh, params),
                                   paint_depth(less, view, kSize));
    EXPECT_GT(d.far, 1000U);
}

}  // namespace
}  // namespace edaha
