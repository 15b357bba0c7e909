// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "flatten/flatten_params.h"
#include "flatten/view_segment.h"
#include "mesh/edges.h"

namespace edaha {

// The mesh's own edges at which what is seen may change: contours between front and back, creases
// between shown triangles that meet at more than `crease_rad`, borders of open surfaces and
// between parts. Edges seen end on are left out. In the order of the edges.
// On closed surfaces contours meet in an even number at every point of the picture. O(edges).
std::vector<ViewSegment> edge_segments(const Mesh& mesh, std::span<const MeshEdge> edges,
                                       const View& view, double crease_rad);

}  // namespace edaha
