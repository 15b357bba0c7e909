// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/planar_map.h"

namespace edaha {

// A chain of half-edges that two regions, or two strokes, have in common. Its curve is made once,
// for `first` to `end` in order; who runs the other way uses it reversed, so nothing cracks.
struct Arc {
    std::uint32_t first = 0, end = 0;  // into ArcSet::half_edges
    bool closed = false;               // ends where it starts, in no particular node
};

struct ArcUse {
    std::uint32_t arc = kNone;
    bool forward = true;
    bool operator==(const ArcUse&) const = default;
};

struct ArcSet {
    std::vector<std::uint32_t> half_edges;
    std::vector<Arc> arcs;
    std::vector<ArcUse> use_of;  // a half-edge; arc kNone where the edge is not kept

    std::span<const std::uint32_t> of(const Arc& arc) const {
        return {half_edges.data() + arc.first, half_edges.data() + arc.end};
    }
};

// Chains of the edges whose `kind` is not 0 (dissolved). They end in nodes where not exactly two
// kept edges meet and where the kind changes: let it tell apart sources and pairs of labels. O(E).
ArcSet cut_arcs(const PlanarMap& map, std::span<const std::uint32_t> kind_of_edge);

// The arcs along a closed ring of half-edges (as trace_region_rings() makes them), each once.
std::vector<ArcUse> arcs_of_ring(const ArcSet& set, std::span<const std::uint32_t> ring);

}  // namespace edaha
