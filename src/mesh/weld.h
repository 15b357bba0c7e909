// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "mesh/mesh.h"

namespace edaha {

// Joins points of one part that are at the very same place, but only those of open edges: a surface
// that was written with a point a corner or a normal closes, pieces that only touch stay apart.
// Points keep their order, of those that are joined the first stays. Linear.
void weld_open(Mesh& mesh);

// Leaves out the points that no triangle names. The others keep their order. Linear.
void drop_unused_points(Mesh& mesh);

}  // namespace edaha
