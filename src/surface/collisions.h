// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

// A vertex and a face of the tree itself that look at each other.
struct FacingPair {
    std::uint32_t vertex = 0, face = 0;
    double distance = 0;  // mm, to the nearest point of the face
    double time = 0;      // when they would be `near_mm` apart, in moves; 0 if they are
};

// Which vertices look ahead, and how far.
struct FacingParams {
    double near_mm = 35;
    double cell_mm = 150;                          // about as long as edges
    std::span<const std::uint32_t> suspects = {};  // vertices whose faces are watched, too
};

// Of each apex and cambium vertex (section 5.3) the faces in front of it that it comes nearer to
// than `near_mm` by this step's `moves`: the normals opposed, each before the other, no corner of
// the face within two edges of the vertex [E]. Sorted by vertices, then faces.
struct Facing {
    std::vector<FacingPair> pairs;
    // Faces round apices and xylem, round pairs, at sharp folds, round suspects: those that may
    // pass through others.
    std::vector<std::uint32_t> watched;
    std::optional<FaceGrid> grid;  // of the mesh as it was
};

// Parallel; O(faces).
Facing facing_pairs(const GrowingMesh& mesh, std::span<const Vec3> of_faces,
                    std::span<const Vec3> normals, std::span<const Vec3> moves,
                    const FacingParams& params);

struct ApartParams {
    double least_mm = 17;   // of pairs
    double cell_mm = 150;   // about as long as edges
    double retreat_mm = 2;  // of faces that pass through each other
};

// Shortens moves, or parts of them, so that no pair comes nearer than `least_mm`, and that no
// watched face begins to pass through any other; those that do so already draw back against their
// normals [E]. The mesh hangs together as it did when the pairs were found. Returns the vertices
// that drew back: suspects of the next step. O(faces + pairs).
std::vector<std::uint32_t> keep_apart(const GrowingMesh& mesh, const Facing& facing,
                                      std::span<const Vec3> normals, const ApartParams& params,
                                      std::vector<Vec3>& moves);

Vec3 nearest_point(const std::array<Vec3, 3>& triangle, const Vec3& p);

// Whether v can be reached from `from` along at most two edges.
bool within_two_rings(const GrowingMesh& mesh, std::uint32_t from, std::uint32_t v);

}  // namespace edaha
