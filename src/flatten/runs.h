// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/arcs.h"

namespace edaha {

// Arcs that go on smoothly through nodes: they are fitted as one curve.
struct Run {
    std::uint32_t first = 0, end = 0;  // into RunSet::uses
    bool closed = false;
};

struct RunSet {
    std::vector<ArcUse> uses;
    std::vector<Run> runs;  // every arc is in one, once

    std::span<const ArcUse> of(const Run& run) const {
        return {uses.data() + run.first, uses.data() + run.end};
    }
};

struct RunParams {
    double window = 2;      // directions are judged over this length, in the map's steps
    double most_turn = 25;  // degrees: sharper turns end a run
};

// At every node the two arcs that continue each other best, and no others, belong to one run: at a
// T-junction the outline of what lies in front. `kind_of_edge` as for cut_arcs(): between equally
// good pairs that of one kind counts. O(E log E).
RunSet join_arcs(const PlanarMap& map, const ArcSet& arcs,
                 std::span<const std::uint32_t> kind_of_edge, const RunParams& params);

// The runs of arcs whose ends are paired: an end is 2 * arc, + 1 for where the arc ends; its
// partner is the end that leaves the same node, kNone where a run ends. Arcs that are not `wanted`
// are in none.
RunSet follow_partners(const ArcSet& arcs, std::span<const std::uint32_t> partner,
                       std::span<const std::uint8_t> wanted);

// An arc as it leaves a node.
struct Spoke {
    std::uint32_t node = 0;
    std::uint32_t end = 0;  // 2 * arc, + 1 where it leaves by its end
    Vec2 direction{0};      // of length 1
    std::uint32_t kind = 0;

    ArcUse use() const { return {end / 2, end % 2 == 0}; }
};

// All wanted arcs that end in nodes, by node and end; directions as leaving_direction().
std::vector<Spoke> spokes_of(const PlanarMap& map, const ArcSet& arcs,
                             std::span<const std::uint32_t> kind_of_edge,
                             std::span<const std::uint8_t> wanted, double window);

// Calls visit(spokes) for the spokes of each node in turn.
template <typename Visit>
void visit_nodes(std::span<const Spoke> spokes, Visit&& visit) {
    for (std::size_t i = 0; i < spokes.size();) {
        std::size_t end = i;
        while (end < spokes.size() && spokes[end].node == spokes[i].node)
            ++end;
        visit(spokes.subspan(i, end - i));
        i = end;
    }
}

// The way an arc leaves a node: to the place on it `window` away as the crow flies, or to its end.
Vec2 leaving_direction(const PlanarMap& map, const ArcSet& arcs, ArcUse from, double window);

// The nodes at an arc's ends.
inline std::uint32_t start_node(const PlanarMap& map, const ArcSet& arcs, ArcUse use) {
    const Arc& arc = arcs.arcs[use.arc];
    return use.forward ? map.origin(arcs.half_edges[arc.first])
                       : map.target(arcs.half_edges[arc.end - 1]);
}
inline std::uint32_t end_node(const PlanarMap& map, const ArcSet& arcs, ArcUse use) {
    return start_node(map, arcs, {use.arc, !use.forward});
}

}  // namespace edaha
