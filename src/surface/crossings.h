// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

using Corners = std::array<Vec3, 3>;

// Whether two triangles pass through each other: an edge of one goes from one side of the other
// to its other side, through its inside. Touching does not count, nor does what they share, nor do
// flat ones that lie on each other: all that is within 1e-9 of their size. Symmetric.
bool triangles_cross(const Corners& s, const Corners& t);

// The pairs of faces that pass through each other, each once, sorted. Of two with a common point
// only what they have in common besides it counts. Parallel; about O(faces).
std::vector<std::array<std::uint32_t, 2>> crossing_faces(const GrowingMesh& mesh);

// Whether a triangle passes through any face of the mesh but those with the corners a or b. Faces
// may have moved by `moved_mm` since the grid was made, and others may be in their places.
bool crosses_any(const GrowingMesh& mesh, const FaceGrid& grid, const Corners& triangle,
                 std::uint32_t a, std::uint32_t b, double moved_mm = 0);

Corners corners_of(const GrowingMesh& mesh, std::uint32_t f);

}  // namespace edaha
