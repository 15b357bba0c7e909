// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>

#include "surface/apex.h"
#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

struct RemeshParams {
    double split_mm = 150;   // T_s
    double merge_mm = 70;    // T_m
    double winding_rad = 0;  // theta_p, a mm of travel
    bool flips = true;
    FaceGrid* grid = nullptr;  // holds the mesh, and goes on doing so; without one it gets its own
    // Whether a face may not lie there: flips and collapses that would make one are left out.
    std::function<bool(const Vec3&, const Vec3&, const Vec3&)> is_barred = {};
    bool only_shrinking = true;  // eq. 2; without it tips are eaten
};

// One round of re-meshing (4.3): edges longer than T_s are split until none is, the longest first;
// those shorter than T_m and than a step before (eq. 2) go, the shortest first; then edges turn to
// where the angles that face them are smaller [E]. Types and places after tables 1 and 2; of an
// apex and xylem the apex keeps its place, though the table prints the other's; xylem with xylem
// goes to the middle [E]; buds stay what and where they are [E]. Lines of phloem stay lines: what
// splits one becomes its member, and where two share a vertex they join and run up as one (6.3).
// The new vertex between an apex and the cambium below is turned about the heading by theta_p times
// the travel between both, so that a line's turns add up to eq. 7. Crotches close (see the source).
// No collapse or flip folds a face over, or lets it pass through another one; nor does winding.
// Deterministic; ties by index. O(edges log changes).
void remesh(GrowingMesh& mesh, std::span<const Apex> apices, const RemeshParams& params);

}  // namespace edaha
