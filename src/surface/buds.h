// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "surface/apex.h"
#include "surface/growing_mesh.h"

namespace edaha {

// Where a bud comes to lie (Mizoguchi & Miyata 5.2, Fig. 10): of the cambium within two edges of an
// apex the vertex whose normal makes the smallest angle with `direction`; the lowest index of
// equals. None if all of it is taken. O(1).
std::optional<std::uint32_t> bud_vertex(const GrowingMesh& mesh, std::span<const Vec3> normals,
                                        std::uint32_t apex, const Vec3& direction);

// Makes the vertex of apex `branch` a growing tip: its line of phloem ends there from below, and
// what was above it begins a line of its own.
void sprout(GrowingMesh& mesh, std::vector<Apex>& apices, std::uint32_t branch);

// A tip that has stopped is cambium from then on, and thickens like its branch [E].
void stop_apex(GrowingMesh& mesh, Apex& apex);

}  // namespace edaha
