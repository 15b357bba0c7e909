// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

using FacePair = std::array<std::uint32_t, 2>;

// Two faces that can't pass through each other for so many steps.
struct ClosePair {
    FacePair faces{};
    std::uint8_t clear = 0;
};

// A step as it is planned: the normals of faces and vertices, and how vertices may go within it,
// any part of their growth and any part of their slide.
struct StepPlan {
    std::span<const Vec3> of_faces, normals, growth, slides;
};

// Round all that faces pass on their ways, and `more_mm` round that.
std::vector<FaceBox> boxes_of_ways(const GrowingMesh& mesh, const StepPlan& plan, double more_mm);

// For how many steps, each like this one, two faces can't pass through each other: a plane stays
// between them, whatever parts of their ways their corners go. Never too many; too few where none
// of the planes tried is the best one, which need not be more than `enough`. Infinite for faces
// that share an edge: they do not count (see triangles_cross).
double clear_steps(const GrowingMesh& mesh, const StepPlan& plan, const FacePair& pair,
                   double enough);

// What is slow rests while nothing can meet it, so that most of a large tree need not be looked at
// in most steps [E].
struct RestParams {
    double fast_mm = 5;      // a step: what grows faster never rests
    double horizon_mm = 35;  // how far is looked beyond what the step needs
};

// How many steps something may rest that nothing is nearer to than `free_mm`: all that is not fast
// may come towards it.
std::uint8_t steps_of_rest(double free_mm, double speed_mm, const RestParams& params);

// Ends the rest of what has become fast: buds that sprout, cambium that a burl reaches. Parallel.
void wake_fast(GrowingMesh& mesh, std::span<const Vec3> growth, double fast_mm);

struct CloseParams {
    RestParams rest = {};
    std::span<const std::uint8_t> is_watched = {};  // a face
    std::span<const FaceBox> boxes = {};            // a face: of its way, as in the grid
    std::span<const ClosePair> before = {};         // what was found a step ago
};

// The pairs of a watched face and any other one that may pass through each other within a step or
// while the first rests: all that do not stay clear of each other so long. Those of a face that
// rests are those that it had before. All faces get their new rest. Parallel; O(watched).
std::vector<ClosePair> close_faces(GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
                                   const CloseParams& params);

// Of those the ones that may pass through each other in this step.
std::vector<FacePair> closest(std::span<const ClosePair> pairs);

}  // namespace edaha
