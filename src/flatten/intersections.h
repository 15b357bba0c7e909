// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "flatten/view_segment.h"

namespace edaha {

struct Crossings {
    std::vector<ViewSegment> segments;
    std::vector<std::uint8_t> flush;  // a triangle: 1 if it may lie in one plane with another
};

// Where triangles that may be seen pass through each other: one segment a pair that shares no
// point. Whether an edge pierces a triangle is decided exactly, on points that are moved aside by
// less than a step (a simple stand-in for Edelsbrunner & Muecke's simulation of simplicity, 1990),
// and where it does is computed from that edge and triangle alone: so segments of neighbouring
// pairs meet in the same grid point. Of surfaces that lie on each other the segments are no lines.
// Sorted by the triangles. Expected O(n log n + boxes that overlap).
Crossings intersect_shown(const View& view, const Mesh& mesh);

}  // namespace edaha
