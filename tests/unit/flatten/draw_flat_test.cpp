// SPDX-License-Identifier: MIT
#include "flatten/draw_flat.h"

#include <optional>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "drawing/check.h"
#include "drawing/page.h"
#include "geometry/walk_path.h"
#include "unit/flatten/painter_scene.h"

namespace edaha {
namespace {

using scenes::Card;

constexpr double kMmPerPx = 0.2;

FlattenInks inks() {
    FlattenInks result;
    result.tones = {{{10, 0, 0}, {20, 0, 0}, {30, 0, 0}}};
    return result;
}

std::vector<Layer> draw(std::span<const Card> cards, const FlattenParams& params) {
    StepClock clock;
    return draw_flat(scenes::map_of(cards), scenes::parts_of(cards), params, inks(),
                     {{0, 0}, kMmPerPx}, clock);
}

// Winding number of a path's chords round a point.
int winding(const Path& path, Vec2 p) {
    int turns = 0;
    walk_path(path, [&](const PathSegment& segment) {
        const Cubic& c = segment.curve;
        const auto [low, high] = std::minmax({c.p0.y, c.p1.y, c.p2.y, c.p3.y});
        if (segment.verb == Verb::move || p.y < low || p.y > high) return;
        const std::vector<Vec2> points = flatten(segment.curve, 1e-3);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2 a = points[i - 1], b = points[i];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            if (a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) > p.x) turns += a.y <= p.y ? 1 : -1;
        }
    });
    return turns;
}

// The part and colour that is painted at a point: all shapes, bottom first.
struct Painted {
    std::string part;
    std::optional<Colour> colour;
};

// Shapes without a colour have the `inherited` one, the layer's.
void paint(const std::vector<Element>& elements, Vec2 p, Colour inherited, const std::string& part,
           Painted& result) {
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element)) {
            paint(group->children, p, inherited, group->id, result);
        } else if (const auto* shape = std::get_if<Shape>(&element)) {
            if (winding(shape->path, p) == 0) continue;
            result.part = shape->id.empty() ? part : shape->id;
            const Ink& fill = shape->paint.fill;
            result.colour = fill.kind == Ink::Kind::inherit ? inherited : fill.colour;
        }
    }
}

// How far a point is from the nearest border of any card.
double border_distance(std::span<const Card> cards, Vec2 p) {
    double least = HUGE_VAL;
    for (const Card& card : cards) {
        for (std::size_t i = 0; i < card.corners.size(); ++i) {
            const Vec2 a = card.corners[i], b = card.corners[(i + 1) % card.corners.size()];
            const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            least = std::min(least, glm::distance(p, a + (b - a) * t));
        }
    }
    return least;
}

TEST(DrawFlat, PaintsWhatTheCardsShow) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const std::vector<Card> cards = scenes::random_scene(25, 150, seed);
        FlattenParams params;
        params.min_area_px2 = 0;
        const std::vector<Layer> layers = draw(cards, params);
        ASSERT_EQ(layers[0].label, "Fills");
        int wrong = 0, asked = 0;
        for (double x = -30; x < 180; x += 1.7) {
            for (double y = -30; y < 180; y += 1.9) {
                // Curves may be this far from their polygons.
                if (border_distance(cards, {x, y}) < params.smoothing_px + 0.1) continue;
                ++asked;
                Painted painted;
                paint(layers[0].children, Vec2(x, y) * kMmPerPx, layers[0].paint.fill.colour, "",
                      painted);
                const FaceLabel label = scenes::seen_at(cards, {x, y});
                const bool sky = label.part == kNone;
                EXPECT_EQ(painted.colour.has_value(), !sky) << x << ", " << y;
                if (sky || !painted.colour) continue;
                wrong += painted.part != "part-" + std::to_string(label.part) ||
                         painted.colour->r != 10 * (label.tone + 1);
            }
        }
        EXPECT_GT(asked, 3000);
        EXPECT_EQ(wrong, 0) << seed;
    }
}

// Of two edges in one place the lower one would show as a hairline.
TEST(DrawFlat, EndsWhatIsPaintedOverBeforeWhatCoversIt) {
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {40, 20}), 0, 1},
                                  {scenes::rectangle({20, 0}, {40, 20}), 0, 2}};
    FlattenParams params;
    params.contour_mm = 0;  // no line hides anything: there is an underlay
    const std::vector<Layer> layers = draw(cards, params);
    const auto seen_to = [&](const Shape& shape, double x) {
        return winding(shape.path, Vec2(x, 10) * kMmPerPx) != 0;
    };
    const double trap_px = params.trap_mm / kMmPerPx;
    ASSERT_EQ(layers[0].children.size(), 2U);
    const Shape& underlay = std::get<Shape>(layers[0].children[0]);
    const Group& part = std::get<Group>(layers[0].children[1]);
    const Shape& base = std::get<Shape>(part.children[0]);
    const Shape& tone = std::get<Shape>(part.children[1]);
    EXPECT_TRUE(seen_to(underlay, 0.1 + trap_px));
    EXPECT_FALSE(seen_to(underlay, trap_px - 0.1));
    EXPECT_TRUE(seen_to(base, 0.1));
    EXPECT_TRUE(seen_to(base, 39.9 - trap_px));
    EXPECT_FALSE(seen_to(base, 40.1 - trap_px));
    EXPECT_TRUE(seen_to(tone, 39.9));
}

TEST(DrawFlat, KeepsTheContractInEveryLook) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const std::vector<Card> cards = scenes::random_scene(80, 250, seed);
        for (const FlatLook look : {FlatLook::fills, FlatLook::lines, FlatLook::fills_lines,
                                    FlatLook::tones, FlatLook::facets, FlatLook::blueprint}) {
            FlattenParams params;
            params.look = look;
            Drawing drawing;
            drawing.layers = draw(cards, params);
            drawing = on_page(std::move(drawing), {}, {});
            EXPECT_EQ(check(drawing), std::vector<std::string>{});
        }
    }
}

TEST(DrawFlat, NamesPartsAsFilesMay) {
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {10, 10}), 0, 0},
                                  {scenes::rectangle({20, 0}, {30, 10}), 1, 0},
                                  {scenes::rectangle({40, 0}, {50, 10}), 2, 0},
                                  {scenes::rectangle({60, 0}, {70, 10}), 3, 0}};
    std::vector<MeshPart> parts = scenes::parts_of(cards);
    parts[0].name = "Lines", parts[1].name = "2nd branch", parts[2].name = "a b";
    parts[3].name = "a-b";
    StepClock clock;
    Drawing drawing;
    drawing.layers = draw_flat(scenes::map_of(cards), parts, {}, inks(), {{0, 0}, 1}, clock);
    std::set<std::string> ids;
    for (const Element& element : drawing.layers[0].children)
        ids.insert(std::get<Shape>(element).id);
    EXPECT_EQ(ids, (std::set<std::string>{"Lines-2", "part-2nd-branch", "a-b", "a-b-2"}));
    drawing = on_page(std::move(drawing), {}, {});
    EXPECT_EQ(check(drawing), std::vector<std::string>{});
}

bool same(const std::vector<Element>& a, const std::vector<Element>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Element& x, const Element& y) {
                          if (const auto* group = std::get_if<Group>(&x))
                              return same(group->children, std::get<Group>(y).children);
                          const auto &s = std::get<Shape>(x), &t = std::get<Shape>(y);
                          return s.id == t.id && s.path.points == t.path.points &&
                                 s.path.verbs == t.path.verbs && s.paint == t.paint;
                      });
}

TEST(DrawFlat, IsTheSameOnOneThread) {
    const std::vector<Card> cards = scenes::random_scene(150, 500, 3);
    const std::vector<Layer> many = draw(cards, {});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const std::vector<Layer> alone = draw(cards, {});
    ASSERT_EQ(many.size(), alone.size());
    for (std::size_t i = 0; i < many.size(); ++i)
        EXPECT_TRUE(same(many[i].children, alone[i].children)) << many[i].label;
}

}  // namespace
}  // namespace edaha
