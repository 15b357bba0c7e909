// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/arcs.h"
#include "geometry/region_rings.h"
#include "map_oracles.h"

namespace edaha {
namespace {

using Segments = std::vector<GridSegment>;

// Segments in a square so small that they overlap, touch and repeat all the time.
Segments any_soup() {
    const int side = *rc::gen::inRange(2, 60);
    const auto at = rc::gen::inRange(-side, side + 1);
    return *rc::gen::container<Segments>(
        rc::gen::map(rc::gen::tuple(at, at, at, at), [](const std::tuple<int, int, int, int>& p) {
            return GridSegment{{std::get<0>(p), std::get<1>(p)}, {std::get<2>(p), std::get<3>(p)}};
        }));
}

bool same(const Arrangement& a, const Arrangement& b) {
    const auto equal = [](const Edge& e, const Edge& f) {
        return e.from == f.from && e.to == f.to;
    };
    return a.nodes == b.nodes &&
           std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), equal);
}

RC_GTEST_PROP(SnapRoundProperty, EdgesTouchOnlyInNodes, ()) {
    RC_ASSERT(oracles::touch_only_in_nodes(snap_round(any_soup())));
}

RC_GTEST_PROP(SnapRoundProperty, OrderAndDirectionDontMatter, ()) {
    const Segments soup = any_soup();
    Segments turned(soup.rbegin(), soup.rend());
    for (GridSegment& s : turned)
        std::swap(s.a, s.b);
    RC_ASSERT(same(snap_round(soup), snap_round(turned)));
}

RC_GTEST_PROP(SnapRoundProperty, MovingTheInputMovesTheResult, ()) {
    const Segments soup = any_soup();
    const std::int32_t dx = *rc::gen::inRange(-1000000, 1000000);
    const std::int32_t dy = *rc::gen::inRange(-1000000, 1000000);
    const auto moved = [&](GridPoint p) { return GridPoint{p.x + dx, p.y + dy}; };
    Segments there;
    for (const GridSegment& s : soup)
        there.push_back({moved(s.a), moved(s.b)});
    Arrangement result = snap_round(soup);
    for (GridPoint& p : result.nodes)
        p = moved(p);
    RC_ASSERT(same(result, snap_round(there)));
}

RC_GTEST_PROP(PlanarMapProperty, EulersFormulaHolds, ()) {
    const PlanarMap map = oracles::map_of(any_soup());
    RC_ASSERT(oracles::nodes_in_use(map) + map.faces() ==
              map.edges.size() + 1 + oracles::components(map));
}

RC_GTEST_PROP(PlanarMapProperty, EveryHalfEdgeIsInOneLoop, ()) {
    const PlanarMap map = oracles::map_of(any_soup());
    std::vector<int> visits(map.next.size(), 0);
    for (std::uint32_t loop = 0; loop < map.loops.size(); ++loop) {
        std::uint32_t h = map.loops[loop].first;
        do {
            ++visits[h];
            RC_ASSERT(map.loop_of[h] == loop);
            RC_ASSERT(map.origin(map.next[h]) == map.target(h));
            h = map.next[h];
        } while (h != map.loops[loop].first && visits[h] == 0);
    }
    for (const int n : visits)
        RC_ASSERT(n == 1);
}

RC_GTEST_PROP(PlanarMapProperty, AreasOfLoopsAddUpToNothing, ()) {
    const PlanarMap map = oracles::map_of(any_soup());
    double sum = 0;
    for (const PlanarMap::Loop& loop : map.loops)
        sum += loop.area;
    RC_ASSERT(sum == 0.0);  // halves of small integers: exact
}

RC_GTEST_PROP(PlanarMapProperty, FacesHoldTheirInteriorPoints, ()) {
    const PlanarMap map = oracles::map_of(any_soup());
    for (std::uint32_t face = 1; face < map.faces(); ++face) {
        RC_ASSERT(face_area(map, face) > 0);
        RC_ASSERT(oracles::face_at(map, interior_point(map, face) + Vec2(1e-9, 0)) == face);
    }
}

// Labels that make neighbours merge and part.
std::vector<std::uint32_t> any_labels(const PlanarMap& map) {
    std::vector<std::uint32_t> labels(map.faces(), 0);
    for (std::size_t i = 1; i < labels.size(); ++i)
        labels[i] = *rc::gen::inRange(0, 3);
    return labels;
}

RC_GTEST_PROP(RegionRingsProperty, RingsAreSimpleAndTheirAreasTheFaces, ()) {
    const PlanarMap map = oracles::map_of(any_soup());
    const std::vector<std::uint32_t> labels = any_labels(map);
    const RegionRings rings = trace_region_rings(map, labels);
    double areas[3] = {0, 0, 0};
    for (std::uint32_t f = 1; f < map.faces(); ++f)
        areas[labels[f]] += face_area(map, f);
    for (const auto& ring : rings.rings) {
        areas[ring.label] -= ring.area;
        std::vector<std::uint32_t> nodes;
        const auto half_edges = rings.of(ring);
        for (std::size_t i = 0; i < half_edges.size(); ++i) {
            const std::uint32_t next = half_edges[(i + 1) % half_edges.size()];
            RC_ASSERT(map.target(half_edges[i]) == map.origin(next));
            nodes.push_back(map.origin(next));
        }
        std::sort(nodes.begin(), nodes.end());
        RC_ASSERT(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
        RC_ASSERT(ring.area != 0.0);
    }
    RC_ASSERT(areas[1] == 0.0);
    RC_ASSERT(areas[2] == 0.0);
}

RC_GTEST_PROP(ArcsProperty, RingsAreMadeOfWholeArcs, ()) {
    const PlanarMap map = oracles::map_of(any_soup());
    const std::vector<std::uint32_t> labels = any_labels(map);
    std::vector<std::uint32_t> kinds;
    for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
        kinds.push_back(labels[map.face_of(2 * e)] != labels[map.face_of(2 * e + 1)]);
    }
    const ArcSet set = cut_arcs(map, kinds);
    std::size_t kept = 0;
    for (const std::uint32_t kind : kinds)
        kept += kind;
    RC_ASSERT(set.half_edges.size() == kept);  // each edge in one arc, once
    const RegionRings rings = trace_region_rings(map, labels);
    for (const auto& ring : rings.rings) {
        std::size_t length = 0;
        for (const ArcUse use : arcs_of_ring(set, rings.of(ring))) {
            length += set.of(set.arcs[use.arc]).size();
        }
        RC_ASSERT(length == rings.of(ring).size());
    }
}

}  // namespace
}  // namespace edaha
