// SPDX-License-Identifier: MIT
#include "flatten/strokes.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "drawing/check.h"
#include "drawing/page.h"
#include "flatten/draw_flat.h"
#include "flatten/taper.h"
#include "geometry/measure.h"
#include "geometry/walk_path.h"
#include "unit/flatten/painter_scene.h"

namespace edaha {
namespace {

using scenes::Card;

constexpr double kMmPerPx = 0.2;

Layer lines_of(LabelledMap map, std::span<const Card> cards, FlattenParams params) {
    params.look = FlatLook::lines;
    StepClock clock;
    return draw_flat(std::move(map), scenes::parts_of(cards), params, {}, {{0, 0}, kMmPerPx}, clock)
        .at(0);
}

std::vector<Path> strokes_of(const Layer& layer) {
    std::vector<Path> paths;
    for (const Element& group : layer.children) {
        for (const Element& shape : std::get<Group>(group).children)
            paths.push_back(std::get<Shape>(shape).path);
    }
    return paths;
}

double total_length_px(const std::vector<Path>& paths) {
    double sum = 0;
    for (const Path& path : paths)
        sum += length(path) / kMmPerPx;
    return sum;
}

TEST(Strokes, FollowASilhouetteRoundCornersAsOneClosedLine) {
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {50, 20}), 0, 0}};
    const std::vector<Path> paths = strokes_of(lines_of(scenes::map_of(cards), cards, {}));
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_EQ(paths[0].verbs.back(), Verb::close);
    EXPECT_NEAR(total_length_px(paths), 140, 1e-6);
}

TEST(Strokes, CoverEveryLineOnce) {
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {60, 20}), 0, 0},
                                  {scenes::rectangle({20, -20}, {40, 60}), 1, 0}};
    // What is seen: the upright in full, the two halves of the other bar beside it.
    const std::vector<Path> paths = strokes_of(lines_of(scenes::map_of(cards), cards, {}));
    EXPECT_NEAR(total_length_px(paths), 200 + 2 * (20 + 20 + 20), 1e-6);
    EXPECT_LE(paths.size(), 3U);
}

TEST(Strokes, NeverTurnBack) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const std::vector<Card> cards = scenes::random_scene(60, 200, seed);
        for (const Path& path : strokes_of(lines_of(scenes::map_of(cards), cards, {}))) {
            Vec2 before(0);
            walk_path(path, [&](const PathSegment& segment) {
                const Cubic& c = segment.curve;
                if (segment.verb == Verb::move || c.p0 == c.p3) {
                    before = Vec2(0);
                    return;
                }
                const Vec2 way = start_direction(c);
                EXPECT_GT(before == Vec2(0) ? 1 : glm::dot(before, way), -0.51) << seed;
                before = end_direction(c);
            });
        }
    }
}

TEST(Strokes, GoOnOverSmallGaps) {
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {60, 20}), 0, 0},
                                  {scenes::rectangle({0, 10}, {60, 20}), 0, 0}};
    // A crease across the card, of which a piece of two pixels is hidden.
    LabelledMap map = scenes::map_of(
        std::vector<Card>{cards[0], cards[1], {scenes::rectangle({29, 10}, {31, 20}), 0, 0}});
    for (std::uint32_t e = 0; e < map.map.edges.size(); ++e) {
        const GridPoint a = map.map.nodes[map.map.edges[e].from];
        const GridPoint b = map.map.nodes[map.map.edges[e].to];
        const bool across = a.y == 10 * 2048 && b.y == 10 * 2048;
        if (across && a.x != 29 * 2048) map.line[e] = LineKind::crease;
    }
    const Layer layer = lines_of(std::move(map), cards, {});
    ASSERT_EQ(layer.children.size(), 2U);
    const Group& creases = std::get<Group>(layer.children[0]);
    EXPECT_EQ(creases.id, "Creases");
    ASSERT_EQ(creases.children.size(), 1U);
    EXPECT_NEAR(length(std::get<Shape>(creases.children[0]).path) / kMmPerPx, 60, 1e-6);
}

TEST(Strokes, LeaveOutShortOnesAndThoseWithoutWidth) {
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {50, 20}), 0, 0},
                                  {scenes::rectangle({10, 5}, {20, 15}), 1, 0}};
    FlattenParams params;
    params.contour_mm = 0;
    EXPECT_EQ(strokes_of(lines_of(scenes::map_of(cards), cards, params)).size(), 1U);
    params.contour_mm = 0.35;
    params.min_line_mm = 10;  // the inner square is 8 mm round
    EXPECT_EQ(strokes_of(lines_of(scenes::map_of(cards), cards, params)).size(), 1U);
    params.min_line_mm = 7;
    EXPECT_EQ(strokes_of(lines_of(scenes::map_of(cards), cards, params)).size(), 2U);
}

TEST(Tapered, ThinsOutToPointsAndIsAsWideAsAskedBetween) {
    const std::vector<CurvePiece> line{{line_cubic({0, 0}, {100, 0}), true, 100}};
    const Path path = tapered(line, {2, 20}, Affine(1, 0, 0, 1, 0, 0));
    EXPECT_EQ(path.points.front(), Vec2(0, 0));
    // Full width over 60, a quarter sine over 20 at both ends.
    EXPECT_NEAR(std::abs(signed_area(path)), 2 * 60 + 2 * 2 * 20 * 2 / 3.14159265, 2);
}

TEST(Tapered, KeepsTheContractRoundCorners) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const std::vector<Card> cards = scenes::random_scene(60, 200, seed);
        FlattenParams params;
        params.taper_mm = 2;
        Drawing drawing;
        drawing.layers.push_back(lines_of(scenes::map_of(cards), cards, params));
        drawing = on_page(std::move(drawing), {}, {});
        EXPECT_EQ(check(drawing), std::vector<std::string>{});
    }
}

}  // namespace
}  // namespace edaha
