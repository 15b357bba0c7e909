// SPDX-License-Identifier: MIT
#include "flatten/make_map.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "support/id_buffer.h"
#include "support/meshes.h"

namespace edaha {
namespace {

using namespace test;

SeenMesh see(const Mesh& mesh, FlattenParams params) {
    StepClock clock;
    return see_mesh(mesh, params, clock);
}

FlattenParams params_for(int size) {
    FlattenParams params;
    params.resolution = size - 4;
    params.look = FlatLook::fills_lines;
    params.camera = {Projection::orthographic, 0.3, 0.4, 0.6};
    return params;
}

// Areas in pixels by part; the background's is not told.
std::map<std::uint32_t, double> areas(const LabelledMap& map) {
    std::map<std::uint32_t, double> areas;
    const double px = map.steps_per_px * map.steps_per_px;
    for (std::uint32_t face = 1; face < map.map.faces(); ++face) {
        if (map.labels[face].part != kNone)
            areas[map.labels[face].part] += face_area(map.map, face) / px;
    }
    return areas;
}

double length_px(const LabelledMap& map, LineKind kind) {
    double length = 0;
    for (std::uint32_t e = 0; e < map.line.size(); ++e) {
        if (map.line[e] != kind) continue;
        const Vec2 along = to_vec(map.map.nodes[map.map.target(2 * e)]) -
                           to_vec(map.map.nodes[map.map.origin(2 * e)]);
        length += glm::length(along) / map.steps_per_px;
    }
    return length;
}

void expect_agreement(const Mesh& mesh, const FlattenParams& params, int size) {
    const SeenMesh seen = see(mesh, params);
    const View fine = project(mesh, params.camera, kFine * params.resolution);
    const Disagreement d =
        compare(paint_depth(mesh, seen.view, size), paint_depth(mesh, fine, kFine * size),
                paint_map(seen.map, size));
    EXPECT_GT(d.covered, 1000U);
    EXPECT_LE(double(d.differ), 0.0003 * double(d.covered)) << d.differ << " of " << d.covered;
    EXPECT_EQ(d.far, 0U);
}

TEST(MakeMap, LabelsAreThoseOfADepthBufferForPrismsThatPassThroughEachOther) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
        expect_agreement(random_prisms(seed, 60), params_for(800), 800);
}

TEST(MakeMap, LabelsAreThoseOfADepthBufferInPerspective) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        FlattenParams params = params_for(800);
        params.camera.projection = Projection::perspective;
        params.camera.field_of_view_rad = 1.2;
        expect_agreement(random_prisms(seed, 60), params, 800);
    }
}

TEST(MakeMap, LabelsAreThoseOfADepthBufferForSmoothSurfaces) {
    Mesh mesh = torus(3, 1, 64, 32);
    add(mesh, sphere({1, 1, 0}, 2, 24));
    add(mesh, sphere({-1, 0.5, 1}, 2, 24));
    expect_agreement(mesh, params_for(800), 800);
}

TEST(MakeMap, ASphereIsOneDiscWithNothingButASilhouette) {
    FlattenParams params = params_for(1000);
    params.camera = {};
    const SeenMesh seen = see(sphere({5, 6, 7}, 2, 90), params);
    const auto covered = areas(seen.map);
    ASSERT_EQ(covered.size(), 1U);
    const double radius = params.resolution / 2;
    // A polygon of 180 corners is 0.02 % smaller than its circle, and so is its border.
    EXPECT_NEAR(covered.at(0), std::numbers::pi * radius * radius, 0.001 * covered.at(0));
    EXPECT_NEAR(length_px(seen.map, LineKind::silhouette), 2 * std::numbers::pi * radius, 5);
    for (const LineKind kind : {LineKind::contour, LineKind::border, LineKind::crease,
                                LineKind::intersection, LineKind::tone})
        EXPECT_EQ(length_px(seen.map, kind), 0);
}

TEST(MakeMap, TheSilhouetteIsClosedHoweverItIsSeen) {
    const Mesh mesh = torus(3, 1, 48, 24);
    for (int i = 0; i < 12; ++i) {
        FlattenParams params = params_for(500);
        params.camera.elevation_rad = -1.5 + 0.27 * i;
        const SeenMesh seen = see(mesh, params);
        std::map<std::uint32_t, int> degree;
        for (std::uint32_t e = 0; e < seen.map.line.size(); ++e) {
            if (seen.map.line[e] != LineKind::silhouette) continue;
            ++degree[seen.map.map.edges[e].from], ++degree[seen.map.map.edges[e].to];
        }
        EXPECT_FALSE(degree.empty());
        for (const auto& [node, count] : degree)
            EXPECT_EQ(count % 2, 0) << "node " << node << ", view " << i;
    }
}

// Two boxes of side 2 that cross in the middle, seen from the front: the one that is nearer by
// 0.5 hides the other where they overlap.
TEST(MakeMap, CrossingBoxesShareTheirAreaByDepth) {
    Mesh mesh = box({-3, -1, -1}, {3, 1, 1});
    add(mesh, box({-1, -3, -0.5}, {1, 3, 1.5}));
    FlattenParams params = params_for(604);
    params.camera = {};
    const auto covered = areas(see(mesh, params).map);
    EXPECT_NEAR(covered.at(0), 8 * 100 * 100, 20);
    EXPECT_NEAR(covered.at(1), 12 * 100 * 100, 20);
}

// The near faces of both lie in one plane: the lower part has it.
TEST(MakeMap, CoplanarFacesBelongToTheLowerPart) {
    Mesh mesh = box({-3, -1, -1}, {3, 1, 1});
    add(mesh, box({-1, -3, -1}, {1, 3, 1}));
    FlattenParams params = params_for(604);
    params.camera = {};
    const auto covered = areas(see(mesh, params).map);
    EXPECT_NEAR(covered.at(0), 12 * 100 * 100, 20);
    EXPECT_NEAR(covered.at(1), 8 * 100 * 100, 20);
}

TEST(MakeMap, ACubeShowsItsThreeEdgesThatMeet) {
    FlattenParams params = params_for(1000);
    params.camera.azimuth_rad = std::numbers::pi / 4;
    params.camera.elevation_rad = std::atan(std::sqrt(0.5));
    const SeenMesh seen = see(box({0, 0, 0}, {1, 1, 1}), params);
    // A regular hexagon: the edges that meet in its middle are half as long as its border, and a
    // radius is half the longer side.
    const double radius = params.resolution / 2;
    EXPECT_NEAR(length_px(seen.map, LineKind::silhouette), 6 * radius, 0.1);
    EXPECT_NEAR(length_px(seen.map, LineKind::crease), 3 * radius, 0.1);
    EXPECT_EQ(length_px(seen.map, LineKind::contour), 0);
}

TEST(MakeMap, AFacetSeenEdgeOnIsNoContour) {
    FlattenParams params = params_for(500);
    params.camera = {};
    const SeenMesh seen = see(box({0, 0, 0}, {3, 2, 1}), params);
    EXPECT_EQ(length_px(seen.map, LineKind::contour), 0);
    EXPECT_EQ(length_px(seen.map, LineKind::crease), 0);
    EXPECT_NEAR(length_px(seen.map, LineKind::silhouette), params.resolution * 10 / 3, 0.1);
}

TEST(MakeMap, WhatIsBehindIsHiddenWhichBlueprintsKeep) {
    Mesh mesh = box({-1, -1, 0}, {1, 1, 1});
    add(mesh, box({-0.5, -0.5, -2}, {0.5, 0.5, -1}));
    FlattenParams params = params_for(804);
    params.camera = {};
    params.look = FlatLook::blueprint;
    const SeenMesh seen = see(mesh, params);
    EXPECT_EQ(areas(seen.map).size(), 1U);
    double hidden = 0;
    for (std::uint32_t e = 0; e < seen.map.hidden.size(); ++e) {
        if (seen.map.hidden[e] == LineKind::none) continue;
        EXPECT_EQ(seen.map.line[e], LineKind::none);
        hidden += glm::length(to_vec(seen.map.map.nodes[seen.map.map.target(2 * e)]) -
                              to_vec(seen.map.map.nodes[seen.map.map.origin(2 * e)]));
    }
    EXPECT_NEAR(hidden / kStepsPerPx, 4 * 400, 1);
}

// n.l = 0.5 on a sphere lit from the eye is a circle of radius sin(60 degrees).
TEST(MakeMap, TonesOfASphereAreRings) {
    FlattenParams params = params_for(1000);
    params.camera = {};
    params.look = FlatLook::tones;
    params.bands = 2;
    params.shade = 0.3, params.shine = 0.7;
    params.tone_smoothing = 0;
    params.light_azimuth_rad = params.light_elevation_rad = 0;
    const SeenMesh seen = see(sphere({0, 0, 0}, 1, 120), params);
    const double radius = params.resolution / 2 * std::sin(std::numbers::pi / 3);
    EXPECT_NEAR(length_px(seen.map, LineKind::tone), 2 * std::numbers::pi * radius, 3);
    double light = 0;
    for (std::uint32_t face = 1; face < seen.map.map.faces(); ++face) {
        if (seen.map.labels[face] == FaceLabel{0, 1}) light += face_area(seen.map.map, face);
    }
    const double px = light / kStepsPerPx / kStepsPerPx;
    EXPECT_NEAR(px, std::numbers::pi * radius * radius, 0.002 * px);
}

// Nothing that a picture shows may depend on how the mesh is stored: areas, and lengths of lines.
TEST(MakeMap, AnotherOrderOfPointsAndTrianglesChangesNothing) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Mesh mesh = random_prisms(seed, 40);
        const SeenMesh one = see(mesh, params_for(600));
        const SeenMesh other = see(shuffled(mesh, seed), params_for(600));
        EXPECT_EQ(one.map.map.nodes, other.map.map.nodes);
        EXPECT_EQ(one.map.labels, other.map.labels);
        EXPECT_EQ(one.map.line, other.map.line);
    }
}

TEST(MakeMap, TheNumberOfThreadsChangesNothing) {
    const Mesh mesh = random_prisms(7, 200);
    const SeenMesh many = see(mesh, params_for(600));
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const SeenMesh one = see(mesh, params_for(600));
    EXPECT_EQ(one.map.map.nodes, many.map.map.nodes);
    EXPECT_EQ(one.map.labels, many.map.labels);
    EXPECT_EQ(one.map.depth, many.map.depth);
    EXPECT_EQ(one.map.line, many.map.line);
}

// Each triangle as four, through the middles of its sides.
Mesh split_flat(const Mesh& mesh) {
    Mesh split = mesh;
    split.triangles.clear(), split.part_of.clear();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [known, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(split.points.size()));
        if (is_new) split.points.push_back((mesh.points[a] + mesh.points[b]) / 2.0);
        return known->second;
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc},
                                  Triangle{ab, bc, ca}}) {
            split.triangles.push_back(t);
            split.part_of.push_back(mesh.part_of[i]);
        }
    }
    return split;
}

// Middles lie on the grid: half a step off at most, so lines are as long and areas as large.
TEST(MakeMap, SplittingFlatTrianglesChangesNothing) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Mesh mesh = random_prisms(seed, 40);
        const SeenMesh whole = see(mesh, params_for(600));
        const SeenMesh split = see(split_flat(mesh), params_for(600));
        const auto expected = areas(whole.map), found = areas(split.map);
        ASSERT_EQ(found.size(), expected.size());
        for (const auto& [part, area] : expected)
            EXPECT_NEAR(found.at(part), area, 0.5) << "part " << part;
        for (const LineKind kind :
             {LineKind::silhouette, LineKind::contour, LineKind::crease, LineKind::intersection}) {
            const double length = length_px(whole.map, kind);
            EXPECT_NEAR(length_px(split.map, kind), length, 1e-3 * length + 1);
        }
    }
}

TEST(MakeMap, MovingByWholeGridStepsMovesNothingInThePicture) {
    Mesh mesh = random_prisms(3, 40);
    for (Vec3& point : mesh.points)  // so that sums with whole numbers are exact
        point = glm::floor(point * 0x1p20) * 0x1p-20;
    const SeenMesh here = see(mesh, params_for(600));
    for (Vec3& point : mesh.points)
        point += Vec3(16, -8, 32);
    const SeenMesh there = see(mesh, params_for(600));
    EXPECT_EQ(here.map.map.nodes, there.map.map.nodes);
    EXPECT_EQ(here.map.labels, there.map.labels);
    EXPECT_EQ(here.map.line, there.map.line);
    EXPECT_NE(here.view.origin, there.view.origin);
}

// A torus seen at an elevation e is outlined by an ellipse with half axes R and R sin e, grown by
// r: Steiner's formula gives its area. High up the hole is the ellipse less r. Low down the hole is
// closed, and of the parallel line inside, one stretch between cusps is seen as a contour.
TEST(MakeMap, ATorusHasTheAreaOfSteinersFormulaAndAContourFromCuspToCusp) {
    const double radius = 3, tube = 1;
    for (const double elevation : {0.15, 1.3}) {
        FlattenParams params = params_for(1000);
        params.camera = {};
        params.camera.elevation_rad = elevation;
        const SeenMesh seen = see(torus(radius, tube, 300, 150), params);
        const double flat = radius * std::sin(elevation);
        double around = 0, inside = 0;  // lengths of the ellipse; of the parallel between cusps
        constexpr int kSteps = 10'000;
        for (int i = 0; i < kSteps; ++i) {
            const double t = 2 * std::numbers::pi * (i + 0.5) / kSteps;
            const double speed = std::hypot(radius * std::sin(t), flat * std::cos(t));
            const double bend = speed * speed * speed / (radius * flat);  // radius of curvature
            const double step = speed * 2 * std::numbers::pi / kSteps;
            around += step;
            inside += bend > tube ? step * (1 - tube / bend) : 0;
        }
        const bool open = elevation > 1;
        const double expected = open ? 2 * tube * around  // both sides of the ellipse
                                     : std::numbers::pi * radius * flat + tube * around +
                                           std::numbers::pi * tube * tube;
        const double px = params.resolution / (2 * (radius + tube));
        EXPECT_NEAR(areas(seen.map).at(0), expected * px * px, 0.001 * expected * px * px);
        // The far half hides behind the near one. Edges of a mesh zigzag along its contour.
        const double contour = length_px(seen.map, LineKind::contour) / px;
        EXPECT_NEAR(contour, open ? 0 : inside / 2, 0.06 * inside / 2);
    }
}

TEST(MakeMap, OpenSheetsHaveBordersAndAnInside) {
    const Mesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    for (const double azimuth : {0.0, std::numbers::pi}) {
        FlattenParams params = params_for(500);
        params.camera = {Projection::orthographic, azimuth, 0, 0.6};
        const SeenMesh seen = see(mesh, params);
        EXPECT_NEAR(areas(seen.map)[0], params.resolution * params.resolution, 1) << azimuth;
    }
}

}  // namespace
}  // namespace edaha
