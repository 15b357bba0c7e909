// SPDX-License-Identifier: MIT
#include "geometry/arcs.h"

#include <gtest/gtest.h>

#include "geometry/region_rings.h"
#include "map_oracles.h"

namespace edaha {
namespace {

using Segments = std::vector<GridSegment>;

// Three columns of a 30 x 10 box: faces at x = 5, 15, 25.
struct Columns {
    PlanarMap map;
    std::vector<std::uint32_t> labels;

    Columns(std::uint32_t left, std::uint32_t middle, std::uint32_t right)
        : map(oracles::map_of({{{0, 0}, {30, 0}},
                               {{0, 10}, {30, 10}},
                               {{0, 0}, {0, 10}},
                               {{10, 0}, {10, 10}},
                               {{20, 0}, {20, 10}},
                               {{30, 0}, {30, 10}}})),
          labels(map.faces(), 0) {
        labels[oracles::face_at(map, {5.5, 5})] = left;
        labels[oracles::face_at(map, {15.5, 5})] = middle;
        labels[oracles::face_at(map, {25.5, 5})] = right;
    }

    // 0 for edges between equal labels, else 1.
    std::vector<std::uint32_t> kinds() const {
        std::vector<std::uint32_t> kinds;
        for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
            kinds.push_back(labels[map.face_of(2 * e)] != labels[map.face_of(2 * e + 1)]);
        }
        return kinds;
    }
};

TEST(RegionRings, EqualNeighboursAreOneRegion) {
    const Columns columns(1, 1, 2);
    const RegionRings rings = trace_region_rings(columns.map, columns.labels);
    ASSERT_EQ(rings.rings.size(), 2u);
    for (const auto& ring : rings.rings)
        EXPECT_EQ(ring.area, ring.label == 1 ? 200 : 100);
}

TEST(RegionRings, AHoleThatTouchesItsOutlineIsARingOfItsOwn) {
    // A triangular hole whose tip lies on the box's border.
    const PlanarMap map = oracles::map_of({{{0, 0}, {20, 0}},
                                           {{20, 0}, {20, 20}},
                                           {{20, 20}, {0, 20}},
                                           {{0, 20}, {0, 0}},
                                           {{10, 0}, {15, 10}},
                                           {{15, 10}, {5, 10}},
                                           {{5, 10}, {10, 0}}});
    std::vector<std::uint32_t> labels(map.faces(), 0);
    labels[oracles::face_at(map, {1.5, 10})] = 1;
    const RegionRings rings = trace_region_rings(map, labels);
    ASSERT_EQ(rings.rings.size(), 2u);
    EXPECT_EQ(rings.rings[0].area + rings.rings[1].area, 350);
    EXPECT_EQ(std::min(rings.rings[0].area, rings.rings[1].area), -50);
}

TEST(Arcs, NeighboursShareTheirArcs) {
    const Columns columns(1, 2, 3);
    const ArcSet set = cut_arcs(columns.map, columns.kinds());
    EXPECT_EQ(set.arcs.size(), 6u);  // 3 x 2 outer chains less the joined ones, 2 inner borders
    const RegionRings rings = trace_region_rings(columns.map, columns.labels);
    std::vector<int> uses(set.arcs.size(), 0);
    for (const auto& ring : rings.rings) {
        std::size_t length = 0;
        for (const ArcUse use : arcs_of_ring(set, rings.of(ring))) {
            ++uses[use.arc];
            length += set.of(set.arcs[use.arc]).size();
        }
        EXPECT_EQ(length, rings.of(ring).size());
    }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 2), 2);
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 1), 4);
}

TEST(Arcs, DissolvedEdgesLeaveOneClosedArc) {
    const Columns columns(1, 1, 1);
    const ArcSet set = cut_arcs(columns.map, columns.kinds());
    ASSERT_EQ(set.arcs.size(), 1u);
    EXPECT_TRUE(set.arcs[0].closed);
    const RegionRings rings = trace_region_rings(columns.map, columns.labels);
    EXPECT_EQ(arcs_of_ring(set, rings.of(rings.rings[0])).size(), 1u);
}

TEST(Arcs, EndWhereTheKindChanges) {
    const Columns columns(1, 1, 1);
    std::vector<std::uint32_t> kinds = columns.kinds();
    for (std::uint32_t e = 0; e < kinds.size(); ++e) {
        const auto y = columns.map.nodes[columns.map.edges[e].from].y;
        if (kinds[e] != 0 && y == columns.map.nodes[columns.map.edges[e].to].y) kinds[e] = 2;
    }
    EXPECT_EQ(cut_arcs(columns.map, kinds).arcs.size(), 4u);
}

}  // namespace
}  // namespace edaha
