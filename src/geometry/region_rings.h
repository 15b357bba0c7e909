// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/planar_map.h"

namespace edaha {

// The borders of the regions that faces of equal label make up.
struct RegionRings {
    struct Ring {
        std::uint32_t label = 0;
        std::uint32_t first = 0, end = 0;  // into half_edges
        double area = 0;                   // positive for outlines, negative for holes
    };
    std::vector<std::uint32_t> half_edges;  // region on the left
    std::vector<Ring> rings;

    std::span<const std::uint32_t> of(const Ring& ring) const {
        return {half_edges.data() + ring.first, half_edges.data() + ring.end};
    }
};

// Closed rings with the region on their left; every half-edge whose own face's label is not 0 and
// not that of its twin's face is in exactly one. No ring visits a node twice: borders that touch
// themselves are cut into simple rings there. `labels` has one entry a face. O(E).
RegionRings trace_region_rings(const PlanarMap& map, std::span<const std::uint32_t> labels);

}  // namespace edaha
