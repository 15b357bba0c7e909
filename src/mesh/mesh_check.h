// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace edaha {

// Coordinates beyond this count as broken: far from double's end even as a volume.
inline constexpr double kFarthest = 1e60;

// What is not as it should be with a mesh, counted. Edges by their two points.
struct MeshReport {
    std::size_t broken_points = 0;     // not finite, or beyond kFarthest
    std::size_t missing_points = 0;    // triangles with a point or part that does not exist
    std::size_t shared_points = 0;     // between parts
    std::size_t flat_triangles = 0;    // with hardly any area: 1e-12 of their longest side's square
    std::size_t double_triangles = 0;  // with the points of an earlier one, in its direction
    std::size_t open_edges = 0;        // with one triangle
    std::size_t crowded_edges = 0;     // with more than two
    std::size_t turned_edges = 0;      // with two that run the same way
    std::size_t inverted_pieces = 0;   // closed, but inside out
    std::size_t pieces = 0;            // not a fault: what hangs together by edges
    bool operator==(const MeshReport&) const = default;

    // Whether surfaces are closed and their sides known.
    bool sound() const;

    // "12 open edges", one line a kind of fault.
    std::vector<std::string> lines() const;
};

// Linear but for sorting; 0.2 us a triangle. Triangles with broken or missing points are left out
// of all counts but their own.
MeshReport validate(const Mesh& mesh);

// As flatten() needs it, for what can be mended:
//   - triangles with broken or missing points, with a point twice, and double ones are left out;
//   - in each piece all triangles run the same way round, the way that most do; in closed ones so
//     that the outside is outside;
//   - parts share no points; points without triangles are left out.
// Holes stay open. Triangles without area stay where they hold others together.
Mesh mend(Mesh mesh);

}  // namespace edaha
