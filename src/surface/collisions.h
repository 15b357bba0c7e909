// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/close_faces.h"
#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

// A vertex and a face of the tree itself that look at each other.
struct FacingPair {
    std::uint32_t vertex = 0, face = 0;
    double distance = 0;  // mm, to the nearest point of the face
    double time = 0;      // when they would be `near_mm` apart, in moves; 0 if they are
};

struct FacingParams {
    double near_mm = 35;
    RestParams rest = {};
    std::span<const std::uint32_t> apices = {};  // vertices: those that grow
};

// What may meet within a step.
struct Facing {
    // Of each apex and cambium vertex (section 5.3) the faces in front of it that it comes nearer
    // to than `near_mm` by this step's growth: the normals opposed, each before the other, no
    // corner of the face within two edges of the vertex [E]. Sorted by vertices, then faces.
    std::vector<FacingPair> pairs;
    std::vector<std::uint8_t> rest;  // a vertex: for so many steps it can't be in any, more or less
};

// Ends the rest of vertices before which one of the apices is, or will be within the step, nearer
// than `near_mm`: those it grazes look at it, not it at them. Parallel; O(apices).
void wake_before(GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
                 const FacingParams& params);

// Vertices that rest are in no pair. `grid` is of the ways of all faces. Parallel; O(vertices).
Facing facing_pairs(const GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
                    const FacingParams& params);

// A face: whether it may pass through others: near an apex, xylem or a pair, at a sharp fold or
// near a suspect. Parallel; O(edges).
std::vector<std::uint8_t> watched_faces(const GrowingMesh& mesh, std::span<const Vec3> of_faces,
                                        std::span<const FacingPair> pairs,
                                        std::span<const std::uint32_t> suspects);

struct ApartParams {
    double least_mm = 17;   // of pairs
    double retreat_mm = 2;  // of faces that pass through each other
    std::span<const FacingPair> pairs = {};
    std::span<const FacePair> closest = {};  // faces that may pass through each other
    // Vertices that have drawn back within the step, and so left their ways.
    std::span<const std::uint32_t> off_their_ways = {};
};

// Shortens moves, parts of the ways that pairs were found for, so that none comes nearer than
// `least_mm`, and that no two close faces begin to pass through each other; those that do so
// already draw back against their normals [E]. The mesh hangs together as it did when the pairs
// were found. Returns the vertices that drew back, sorted. O(pairs).
std::vector<std::uint32_t> keep_apart(const GrowingMesh& mesh, std::span<const Vec3> normals,
                                      const FaceGrid& grid, const ApartParams& params,
                                      std::vector<Vec3>& moves);

// Whether v can be reached from `from` along at most two edges.
bool within_two_rings(const GrowingMesh& mesh, std::uint32_t from, std::uint32_t v);

}  // namespace edaha
