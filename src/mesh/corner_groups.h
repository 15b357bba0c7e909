// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/edges.h"

namespace edaha {

// Which corners of triangles (3 t + k) share a normal: those at one point whose triangles hang
// together by edges that turn by `crease_rad` or less. A corner: the lowest of its group.
// `edges` are mesh_edges(mesh). Nearly linear.
std::vector<std::uint32_t> group_corners(const Mesh& mesh, std::span<const MeshEdge> edges,
                                         double crease_rad);

}  // namespace edaha
