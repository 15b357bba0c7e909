// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/none.h"
#include "geometry/snap_round.h"

namespace edaha {

// Half-edge 2e runs along edge e, from -> to; 2e + 1 back.
inline std::uint32_t twin(std::uint32_t half_edge) {
    return half_edge ^ 1u;
}

// The faces that an arrangement divides the plane into. "Left" is where cross products are
// positive. Every half-edge has one face to its left, whose border it follows; a face has one
// outer loop (positive area) and a hole loop (negative or no area) for each component inside.
// Face 0 is the unbounded one. V - E + F = 1 + C holds for C components.
struct PlanarMap {
    struct Loop {
        std::uint32_t first = 0;  // a half-edge: the one that leaves the loop's smallest node
        std::uint32_t face = 0;
        double area = 0;  // signed; rounded once, from the exact sum
    };
    std::vector<GridPoint> nodes;
    std::vector<Edge> edges;
    std::vector<std::uint32_t> next;     // a half-edge: the following one on its loop
    std::vector<std::uint32_t> loop_of;  // a half-edge
    std::vector<Loop> loops;
    std::vector<std::uint32_t> first_loop;  // into face_loops; faces + 1
    std::vector<std::uint32_t> face_loops;  // the outer loop first

    std::size_t faces() const { return first_loop.size() - 1; }
    std::uint32_t origin(std::uint32_t half_edge) const {
        const Edge& edge = edges[half_edge / 2];
        return half_edge % 2 == 0 ? edge.from : edge.to;
    }
    std::uint32_t target(std::uint32_t half_edge) const { return origin(twin(half_edge)); }
    std::uint32_t face_of(std::uint32_t half_edge) const { return loops[loop_of[half_edge]].face; }
    std::span<const std::uint32_t> loops_of(std::uint32_t face) const {
        return {face_loops.data() + first_loop[face], face_loops.data() + first_loop[face + 1]};
    }
};

// Nodes are sorted, edges run from smaller to larger ones and touch only in nodes, all as
// snap_round() leaves them. Nodes without edges belong to no loop. Expected O(E log E).
PlanarMap build_planar_map(std::vector<GridPoint> nodes, std::vector<Edge> edges);

// The face's area: its outer loop less its holes; 0 for the unbounded face.
double face_area(const PlanarMap& map, std::uint32_t face);

// A point strictly inside the bounded face, well away from its border on one horizontal line half
// a step off the grid. O(size of the face).
Vec2 interior_point(const PlanarMap& map, std::uint32_t face);

}  // namespace edaha
