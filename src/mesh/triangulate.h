// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace edaha {

// Cuts a polygon in space, convex or not, into triangles that run round as it does: ears, in the
// coordinate plane that it faces most by its normal (Newell's, the sum of all cross products).
// Indices into `polygon`; always two triangles less than it has points. Where its sides cross or it
// has no area they overlap or are flat. O(n^2), at worst.
std::vector<Triangle> triangulate(std::span<const Vec3> polygon);

}  // namespace edaha
