// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "surface/growing_mesh.h"

namespace edaha {

// Of length 1 outwards, a face: free ones and those without area have 0. Parallel.
std::vector<Vec3> face_normals(const GrowingMesh& mesh);

// The normalised sum of the normals of the faces round each vertex (eq. 5); 0 where they cancel.
// Round the foot only of faces that rise, and level: so a trunk widens on the ground, as fast as
// elsewhere, and its sole stays flat [E].
std::vector<Vec3> vertex_normals(const GrowingMesh& mesh, std::span<const Vec3> of_faces);

// Keeps what stands on the ground there, and nothing goes below it. Parallel.
void stay_on_ground(const GrowingMesh& mesh, std::vector<Vec3>& moves);

// Shortens what would fold the mesh: a vertex goes half as far, a quarter, or not at all, while a
// face of it would turn by more than 80 degrees or lose nine tenths of its area [E]. All stays on
// the ground. O(faces) a round, four rounds.
void limit_moves(const GrowingMesh& mesh, std::span<const Vec3> of_faces, std::vector<Vec3>& moves);

// How cambium slides towards the middle of its neighbours: by a share of the way, along the
// surface, never out of it; not on phloem, beside an apex or on the ground [E]. O(edges).
std::vector<Vec3> slides(const GrowingMesh& mesh, std::span<const Vec3> normals, double share);

// Below this a vertex stands on the ground.
inline constexpr double kGround_mm = 1e-6;

}  // namespace edaha
