// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

using Corners = std::array<Vec3, 3>;

// Whether two triangles pass through each other: an edge of one goes from one side of the other
// to its other side, through its inside. Touching does not count, nor does what they share, nor do
// flat ones that lie on each other: all that is within 1e-9 of their size. Symmetric.
bool triangles_cross(const Corners& s, const Corners& t);

// Of a triangle, to p.
Vec3 nearest_point(const Corners& triangle, const Vec3& p);

// The pairs of faces that pass through each other, each once, sorted. Of two with a common point
// only what they have in common besides it counts. Parallel; about O(faces).
std::vector<std::array<std::uint32_t, 2>> crossing_faces(const GrowingMesh& mesh);

Corners corners_of(const GrowingMesh& mesh, std::uint32_t f);

// Whether a triangle passes through any face, where corners(f) gives a face's place, or nothing if
// it does not count.
template <typename CornersOf>
bool crosses_any(const FaceGrid& grid, const Corners& triangle, const CornersOf& corners) {
    bool crosses = false;
    grid.visit(box_round(triangle[0], triangle[1], triangle[2]), [&](std::uint32_t f) {
        if (crosses) return;
        const std::optional<Corners> other = corners(f);
        crosses = other && triangles_cross(triangle, *other);
    });
    return crosses;
}

}  // namespace edaha
