// SPDX-License-Identifier: MIT
#include "flatten/bark_layer.h"

#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "bark_sheet.h"
#include "flatten/bark_cover.h"
#include "flatten/make_map.h"

namespace edaha {
namespace {

constexpr double kSway = 0.21;  // in tiles: at most what bark_cover.h sways places by

// Upright lines from bottom to top, evenly apart: a pattern that has no seam.
BarkTile upright_lines(int count) {
    BarkTile tile{10, 10, {}};
    for (int i = 0; i < count; ++i) {
        BarkLine line;
        const double x = 10 * (i + 0.5) / count;
        line.points = {{x, 0}, {x, 5}, {x, 10}};
        line.widths_mm = {1, 1, 1};
        tile.lines.push_back(line);
    }
    return tile;
}

Mesh sheet() {
    Mesh mesh;
    mesh.materials.push_back({"wood", {}});
    add_sheet(mesh, {0, 0}, {40, 80}, 0);
    return mesh;
}

FlattenParams plain() {
    FlattenParams params;
    params.resolution = 800;
    params.bark_shade = 0;
    return params;
}

struct Traced {
    std::vector<TileStroke> strokes;
    double px_per_unit = 1;
    Vec2 origin{0};

    Vec2 place(Vec2 px) const {  // on the sheet
        return Vec2(px.x - origin.x, origin.y - px.y) / px_per_unit;
    }
};

// A unit is a millimetre on the page.
Traced trace(const Mesh& mesh, const BarkTile& tile, const FlattenParams& params = plain()) {
    StepClock clock;
    const SeenMesh seen = see_mesh(mesh, params, clock);
    Traced result;
    result.px_per_unit = seen.view.steps_per_unit / kStepsPerPx;
    result.origin = seen.view.origin / double(kStepsPerPx);
    FlatPlace place;
    place.mm_per_px = 1 / result.px_per_unit;
    result.strokes = trace_tile({mesh, seen.view, seen.tones, seen.rays}, tile, params, place);
    return result;
}

double length_of(const TileStroke& stroke) {
    double sum = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        sum += glm::distance(stroke.points[i - 1], stroke.points[i]);
    return sum;
}

double total_length(const Traced& traced) {
    double sum = 0;
    for (const TileStroke& stroke : traced.strokes)
        sum += length_of(stroke) / traced.px_per_unit;
    return sum;
}

TEST(TraceTile, LaysTheTileOverTheSurfaceAtItsSize) {
    const Traced traced = trace(sheet(), upright_lines(1));
    // Four lines of 80.
    EXPECT_NEAR(total_length(traced), 320, 20);
    for (const TileStroke& stroke : traced.strokes) {
        for (const Vec2 p : stroke.points) {
            const double x = traced.place(p).x / 10;
            EXPECT_NEAR(x - std::floor(x), 0.5, kSway);
        }
        for (const double width : stroke.widths_px)
            EXPECT_LT(width, 1.4 * traced.px_per_unit);
    }
}

TEST(TraceTile, ScalesTheTile) {
    FlattenParams half = plain();
    half.bark_scale = 0.5;
    EXPECT_NEAR(total_length(trace(sheet(), upright_lines(1), half)), 640, 40);
}

TEST(TraceTile, FollowsTheShearOfPlaces) {
    Mesh mesh = sheet();
    for (auto& triangle : mesh.uv) {
        for (Vec2& place : triangle)
            place.x -= 0.5 * place.y;  // as phloem that winds
    }
    const Traced traced = trace(mesh, upright_lines(1));
    ASSERT_FALSE(traced.strokes.empty());
    for (const TileStroke& stroke : traced.strokes) {
        const Vec2 way = traced.place(stroke.points.back()) - traced.place(stroke.points.front());
        if (std::abs(way.y) < 10) continue;
        EXPECT_NEAR(way.x / way.y, 0.5, 0.25);
    }
}

TEST(TraceTile, EndsWhereSomethingHidesIt) {
    Mesh mesh = sheet();
    mesh.materials.push_back({"leaf", {}});
    add_sheet(mesh, {-5, 33}, {45, 47}, 8);
    mesh.parts[1].material = 1;  // has none of its own
    const Traced traced = trace(mesh, upright_lines(1));
    std::size_t near = 0;
    for (const TileStroke& stroke : traced.strokes) {
        for (const Vec2 p : stroke.points) {
            const double y = traced.place(p).y;
            EXPECT_TRUE(y < 33.1 || y > 46.9) << y;
            if (std::abs(y - 33) < 0.2 || std::abs(y - 47) < 0.2) ++near;
        }
    }
    EXPECT_GE(near, 6U);  // up to it
}

TEST(TraceTile, ThinsOutWhatIsSeenObliquely) {
    FlattenParams turned = plain();
    turned.camera.azimuth_rad = 70 * std::numbers::pi / 180;
    const BarkTile tile = upright_lines(20);
    const double straight = total_length(trace(sheet(), tile));
    const double oblique = total_length(trace(sheet(), tile, turned));
    EXPECT_GT(oblique, 0);
    EXPECT_LT(oblique, 0.7 * straight);
}

TEST(TraceTile, GathersInTheShade) {
    const auto of_light = [](double from_right) {
        FlattenParams params = plain();
        params.look = FlatLook::tones;
        params.bark_shade = 1;
        params.light_azimuth_rad = from_right;
        params.light_elevation_rad = 0;
        return total_length(trace(sheet(), upright_lines(4), params));
    };
    const double lit = of_light(0), half_lit = of_light(0.9), shaded = of_light(3);
    EXPECT_LT(lit, 0.5 * half_lit);
    EXPECT_LT(half_lit, shaded);
}

TEST(TraceTile, LeavesUnseenAndPlacelessSurfacesBare) {
    FlattenParams behind = plain();
    behind.camera.azimuth_rad = std::numbers::pi;
    EXPECT_TRUE(trace(sheet(), upright_lines(1), behind).strokes.empty());
    Mesh placeless = sheet();
    placeless.uv.clear();
    EXPECT_TRUE(trace(placeless, upright_lines(1)).strokes.empty());
    EXPECT_TRUE(trace(sheet(), {}).strokes.empty());
}

// A few triangles whose places are all but one say nothing of the size of the rest.
TEST(TraceTile, BearsTrianglesWhosePlacesCollapsed) {
    Mesh mesh = sheet();
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Vec3 p : {Vec3(0, 80, 0), Vec3(10, 80, 0), Vec3(10, 90, 0)})
        mesh.points.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.uv.push_back({Vec2(0, 80), Vec2(1e-3, 80), Vec2(1e-3, 80 + 1e-3)});
    mesh.part_of.push_back(0);
    EXPECT_NEAR(total_length(trace(mesh, upright_lines(1))), 320, 30);
}

// A tube about y, its u going round by 2 pi a turn: a seam at the back.
Mesh tube(double radius, int sides) {
    Mesh mesh;
    mesh.materials.push_back({"wood", {}});
    mesh.parts.push_back({"tube", 0, -1, 0, {}});
    const auto ring = static_cast<std::uint32_t>(sides);
    for (const double y : {0.0, 40.0}) {
        for (int i = 0; i < sides; ++i) {
            const double a = 2 * std::numbers::pi * i / sides;
            mesh.points.push_back({-radius * std::sin(a), y, -radius * std::cos(a)});
        }
    }
    const double step = 2 * std::numbers::pi * radius / sides;
    for (std::uint32_t i = 0; i < ring; ++i) {
        const std::uint32_t j = (i + 1) % ring;
        const double u = step * i;
        mesh.triangles.push_back({i, j, ring + j});
        mesh.uv.push_back({Vec2(u, 0), Vec2(u + step, 0), Vec2(u + step, 40)});
        mesh.triangles.push_back({i, ring + j, ring + i});
        mesh.uv.push_back({Vec2(u, 0), Vec2(u + step, 40), Vec2(u, 40)});
        mesh.part_of.insert(mesh.part_of.end(), 2, 0);
    }
    return mesh;
}

TEST(LayBark, TakesAWholeNumberOfTilesRoundAPart) {
    for (const double radius : {3.0, 10.0, 17.0}) {
        const Mesh mesh = tube(radius, 48);
        FlattenParams params = plain();
        StepClock clock;
        const SeenMesh seen = see_mesh(mesh, params, clock);
        const PartCover cover = lay_bark(mesh, seen.view, upright_lines(1), {}).front();
        EXPECT_NEAR(cover.around, 2 * std::numbers::pi * radius, 1e-9);
        const double count = cover.around / cover.tile.x;
        EXPECT_NEAR(count, std::round(count), 1e-9);
        EXPECT_NEAR(count, 2 * std::numbers::pi * radius / 10, 0.5 + 1e-9);
    }
}

// Whichever way the tube is turned, as many strokes are seen: no seam doubles or loses them.
TEST(TraceTile, HasNoSeam) {
    std::map<int, double> lengths;
    for (const int turn : {0, 90, 180, 270}) {
        FlattenParams params = plain();
        params.camera.azimuth_rad = turn * std::numbers::pi / 180;
        lengths[turn] = total_length(trace(tube(20, 96), upright_lines(5), params));
    }
    EXPECT_GT(lengths[0], 200);
    for (const auto& [turn, length] : lengths)
        EXPECT_NEAR(length, lengths[0], 0.12 * lengths[0]) << turn;
}

TEST(DrawTileBark, ClosesEachStrokeInItsPartsGroup) {
    const Mesh mesh = sheet();
    const Traced traced = trace(mesh, upright_lines(2));
    FlatPlace place;
    place.mm_per_px = 1 / traced.px_per_unit;
    const Layer layer = draw_tile_bark(traced.strokes, mesh, plain(), {}, place);
    EXPECT_EQ(layer.label, "Bark");
    ASSERT_EQ(layer.children.size(), 1U);
    const Group& group = std::get<Group>(layer.children[0]);
    EXPECT_EQ(group.id, "sheet-0-bark");
    EXPECT_EQ(group.children.size(), traced.strokes.size());
    for (const Element& element : group.children)
        EXPECT_EQ(std::get<Shape>(element).path.verbs.back(), Verb::close);
}

}  // namespace
}  // namespace edaha
