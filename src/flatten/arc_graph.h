// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/arcs.h"

namespace edaha {

// An arc as it leaves a node.
struct Spoke {
    std::uint32_t node = 0;
    std::uint32_t end = 0;  // 2 * arc, + 1 where it leaves by its end
    Vec2 direction{0};      // of length 1
    std::uint32_t kind = 0;

    ArcUse use() const { return {end / 2, end % 2 == 0}; }
};

// The arcs of a map between nodes. Nodes that short arcs connect are one: all arcs that meet in one
// of them end in one place, and the short arcs vanish.
struct ArcGraph {
    const PlanarMap& map;
    std::span<const std::uint32_t> kind_of_edge;  // as for cut_arcs()
    ArcSet arcs;
    struct Ends {
        std::uint32_t start = 0, end = 0;  // nodes
        double length = 0;                 // along its edges, in steps
    };
    std::vector<Ends> ends;              // an arc
    std::vector<std::uint8_t> vanished;  // an arc

    std::uint32_t kind(std::uint32_t arc) const {
        return kind_of_edge[arcs.half_edges[arcs.arcs[arc].first] / 2];
    }
    // The half-edges of a use in order, by their number.
    std::uint32_t half_edge(ArcUse use, std::size_t i) const {
        const Arc& arc = arcs.arcs[use.arc];
        return use.forward ? arcs.half_edges[arc.first + i]
                           : twin(arcs.half_edges[arc.end - 1 - i]);
    }
    std::uint32_t first_half_edge(ArcUse use) const { return half_edge(use, 0); }
    std::uint32_t last_half_edge(ArcUse use) const {
        return twin(half_edge({use.arc, !use.forward}, 0));
    }
    std::size_t size(std::uint32_t arc) const { return arcs.of(arcs.arcs[arc]).size(); }
    std::uint32_t start_node(ArcUse use) const {
        return use.forward ? ends[use.arc].start : ends[use.arc].end;
    }
    std::uint32_t end_node(ArcUse use) const { return start_node({use.arc, !use.forward}); }
    double length(std::uint32_t arc) const { return ends[arc].length; }
};

struct ContractParams {
    double shortest = 0;                       // steps
    std::span<const std::uint8_t> is_outer{};  // a face: 1 for the background
};

// Arcs shorter than `shortest` vanish, if what becomes one node measures no more than twice that,
// and if that doesn't pinch off what is thin: arcs that run from background to background stay.
// The shortest first; a node is stood for by the one of the longest arc. O(E).
ArcGraph make_arc_graph(const PlanarMap& map, std::span<const std::uint32_t> kind_of_edge,
                        const ContractParams& params);

// All arcs that are `wanted` and end in nodes, by node and end. Directions are those to the place
// on the arc that is `window` steps away as the crow flies, or to its end.
std::vector<Spoke> spokes_of(const ArcGraph& graph, std::span<const std::uint8_t> wanted,
                             double window);

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

}  // namespace edaha
