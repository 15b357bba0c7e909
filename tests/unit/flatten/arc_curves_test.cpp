// SPDX-License-Identifier: MIT
#include "flatten/arc_curves.h"

#include <algorithm>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "flatten/kept_edges.h"
#include "flatten/seen_regions.h"
#include "unit/flatten/painter_scene.h"

namespace edaha {
namespace {

using scenes::Card;

// All that fit_arcs() needs, from cards.
struct Fitted {
    explicit Fitted(std::span<const Card> cards, double shortest_px = 0.4)
        : map(scenes::map_of(cards)),
          regions(find_regions(map)),
          kinds(kept_edges(map, FlatLook::tones)),
          is_outer(map.map.faces()),
          graph(make(shortest_px)),
          runs(join_arcs(graph, {2 * map.steps_per_px, 25})),
          curves(fit_arcs(graph, runs, {map.steps_per_px, regions.width, {}})) {}

    ArcGraph make(double shortest_px) {
        for (std::size_t f = 0; f < is_outer.size(); ++f)
            is_outer[f] = map.labels[f].part == kNone;
        return make_arc_graph(map.map, kinds, {shortest_px * map.steps_per_px, is_outer});
    }
    // The place where an arc starts; on its run where it is too short to have pieces.
    Vec2 start(ArcUse use) const {
        const CurveSpan span = curves.span(use);
        const std::vector<CurvePiece> pieces = pieces_along(curves, {&span, 1});
        if (!pieces.empty()) return pieces.front().curve.p0;
        const std::vector<CurvePiece>& run = curves.runs[span.run].pieces;
        const std::size_t i = std::min(static_cast<std::size_t>(span.from), run.size() - 1);
        return eval(run[i].curve, span.from - static_cast<double>(i));
    }

    LabelledMap map;
    SeenRegions regions;
    std::vector<std::uint32_t> kinds;
    std::vector<std::uint8_t> is_outer;
    ArcGraph graph;
    RunSet runs;
    ArcCurves curves;
};

// A disc before a bar: two T-junctions on each side.
const std::vector<Card> kDiscBeforeBar{{scenes::bar({0, 50}, {100, 50}, 12), 0, 0},
                                       {scenes::ellipse({50, 50}, {25, 25}, 64), 1, 0}};

TEST(FitArcs, RunsTheOutlineOfWhatIsInFrontThroughTJunctions) {
    const Fitted f(kDiscBeforeBar);
    // The disc's outline is one closed run of four arcs, cut without changing its shape.
    const auto disc = std::find_if(f.runs.runs.begin(), f.runs.runs.end(),
                                   [](const auto& run) { return run.closed; });
    ASSERT_NE(disc, f.runs.runs.end());
    EXPECT_EQ(disc->end - disc->first, 4U);
    for (const CurvePiece& piece :
         f.curves.runs[static_cast<std::size_t>(disc - f.runs.runs.begin())].pieces) {
        for (int i = 0; i <= 16; ++i)
            EXPECT_NEAR(glm::distance(eval(piece.curve, i / 16.0), Vec2(50, 50)), 25, 0.55);
    }
}

// In every node all arcs start in the same place, bit by bit or as near as straight lines are moved
// without being cut.
void expect_closed_nodes(const Fitted& f) {
    std::map<std::uint32_t, Vec2> places;
    for (std::uint32_t a = 0; a < f.graph.ends.size(); ++a) {
        if (f.graph.vanished[a] || f.graph.arcs.arcs[a].closed) continue;
        for (const bool forward : {true, false}) {
            const Vec2 p = f.start({a, forward});
            const auto [known, is_new] = places.emplace(f.graph.start_node({a, forward}), p);
            EXPECT_LT(glm::distance(known->second, p), 0.005) << "arc " << a;
        }
    }
}

TEST(FitArcs, EndsAllArcsOfANodeInOnePlace) {
    expect_closed_nodes(Fitted(kDiscBeforeBar));
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        expect_closed_nodes(Fitted(scenes::random_scene(60, 200, seed)));
}

TEST(FitArcs, StaysNearTheMap) {
    const std::vector<Card> cards = scenes::random_scene(60, 200, 7);
    const Fitted f(cards);
    for (std::uint32_t a = 0; a < f.graph.ends.size(); ++a) {
        if (f.graph.vanished[a]) continue;
        const CurveSpan span = f.curves.span({a, true});
        std::vector<Vec2> curve;
        for (const CurvePiece& piece : pieces_along(f.curves, {&span, 1})) {
            const std::vector<Vec2> points = flatten(piece.curve, 0.05);
            curve.insert(curve.end(), points.begin(), points.end());
        }
        for (const std::uint32_t h : f.graph.arcs.of(f.graph.arcs.arcs[a])) {
            const Vec2 node = to_vec(f.map.map.nodes[f.map.map.origin(h)]) / 2048.0;
            double least = HUGE_VAL;
            for (std::size_t i = 1; i < curve.size(); ++i) {
                const Vec2 d = curve[i] - curve[i - 1];
                const double length2 = glm::dot(d, d);
                const double t =
                    length2 > 0 ? std::clamp(glm::dot(node - curve[i - 1], d) / length2, 0.0, 1.0)
                                : 0;
                least = std::min(least, glm::distance(node, curve[i - 1] + d * t));
            }
            EXPECT_LT(least, 1.3) << "arc " << a;
        }
    }
}

TEST(FitArcs, MakesOneNodeOfNodesThatShortArcsConnect) {
    // Three squares meet nearly in one point.
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {20, 20}), 0, 0},
                                  {scenes::rectangle({20, 0}, {40, 20}), 1, 0},
                                  {scenes::rectangle({0, 20}, {20.2, 40}), 2, 0},
                                  {scenes::rectangle({20.2, 20}, {40, 40}), 3, 0}};
    const auto vanished = [](const Fitted& f) {
        return std::count(f.graph.vanished.begin(), f.graph.vanished.end(), 1);
    };
    EXPECT_EQ(vanished(Fitted(cards)), 1);
    EXPECT_EQ(vanished(Fitted(cards, 0.1)), 0);
    expect_closed_nodes(Fitted(cards));
}

TEST(FitArcs, DoesNotPinchTwigs) {
    // A twig of a third of a pixel in three parts, between two blocks.
    const std::vector<Card> cards{{scenes::rectangle({0, 0}, {10, 10}), 0, 0},
                                  {scenes::rectangle({10, 5}, {20, 5.3}), 1, 0},
                                  {scenes::rectangle({20, 5}, {30, 5.3}), 2, 0},
                                  {scenes::rectangle({30, 0}, {40, 10}), 3, 0}};
    const Fitted f(cards);
    EXPECT_EQ(std::count(f.graph.vanished.begin(), f.graph.vanished.end(), 1), 0);
}

TEST(PiecesAlong, GivesTheSameCurveBothWays) {
    const Fitted f(kDiscBeforeBar);
    for (std::uint32_t a = 0; a < f.graph.ends.size(); ++a) {
        const CurveSpan there = f.curves.span({a, true}), back = f.curves.span({a, false});
        std::vector<CurvePiece> forward = pieces_along(f.curves, {&there, 1});
        const std::vector<CurvePiece> backward = pieces_along(f.curves, {&back, 1});
        ASSERT_EQ(forward.size(), backward.size());
        std::reverse(forward.begin(), forward.end());
        for (std::size_t i = 0; i < forward.size(); ++i) {
            EXPECT_EQ(forward[i].curve.p0, backward[i].curve.p3);
            EXPECT_EQ(forward[i].curve.p1, backward[i].curve.p2);
        }
    }
}

}  // namespace
}  // namespace edaha
