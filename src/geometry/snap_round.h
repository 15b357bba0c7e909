// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/grid_point.h"

namespace edaha {

// One passage of an input segment along an edge.
struct EdgeUse {
    std::uint32_t segment = 0;  // index into the input
    bool forward = true;        // segment and edge run the same way
};

// Edges between nodes; from < to, and equal edges are one.
struct Edge {
    std::uint32_t from = 0, to = 0;
};

// Straight edges that touch only in nodes.
struct Arrangement {
    std::vector<GridPoint> nodes;          // unique, sorted
    std::vector<Edge> edges;               // sorted
    std::vector<std::uint32_t> first_use;  // into uses; edges.size() + 1
    std::vector<EdgeUse> uses;             // by segment within an edge

    std::span<const EdgeUse> uses_of(std::size_t edge) const {
        return {uses.data() + first_use[edge], uses.data() + first_use[edge + 1]};
    }
};

// Snap rounding (J. D. Hobby, "Practical segment intersection with finite precision output",
// 1999): every grid point whose unit pixel holds an end or a proper crossing becomes a node, and
// each segment is bent through all nodes whose pixels it passes. Pixels are half open,
// [-1/2, 1/2) on both axes. Nothing moves by more than a pixel's half diagonal, no two edges
// cross, and a segment's order along any line of the grid is kept. All tests are exact. Segments
// that end up in one node vanish. Rounding the result again may bend an edge through a node that
// it now comes close to. Coordinates within kGridLimit.
// Expected O((n + k) log(n + k)) for k crossings.
Arrangement snap_round(std::span<const GridSegment> segments);

}  // namespace edaha
