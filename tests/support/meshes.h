// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "mesh/mesh.h"

namespace edaha::test {

// Closed shapes of one part each, outside out. add() puts them into one mesh as parts of their own.
Mesh box(Vec3 min, Vec3 max);
Mesh sphere(Vec3 centre, double radius, int rings);
Mesh torus(double radius, double tube_radius, int around, int across);
Mesh prism(Vec3 from, Vec3 to, double radius, int sides);
Mesh sheet(Vec3 corner, Vec3 along, Vec3 across);  // open

void add(Mesh& mesh, const Mesh& more);

// So many prisms, in any place and direction within a cube of side 10: they pass through each
// other.
Mesh random_prisms(std::uint64_t seed, int count);

// The same shape with its points and triangles in another order.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed);

}  // namespace edaha::test
