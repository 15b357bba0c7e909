// SPDX-License-Identifier: MIT
#pragma once
#include <glm/mat3x3.hpp>

#include "mesh/mesh.h"

namespace edaha {

using Mat3 = glm::dmat3;

// Rotations that take a branch's y axis onto the direction `g` (any length above 0). The paper's
// axes are left-handed; seen in a mirror (z for -z) its rotations keep their form, so all is
// right-handed from here on.

// Uehara & Takai 5: about x by -theta, then about z by -phi. With sines from square roots rather
// than arc tangents every direction works, drooping ones too [E]. Turns fast round g where g is
// near the z axis.
Mat3 paper_frame(Vec3 g);

// The least rotation that takes the y axis of `from` onto `g`, after `from` [E]: branches that turn
// little are twisted against each other not at all.
Mat3 parallel_frame(const Mat3& from, Vec3 g);

}  // namespace edaha
