// SPDX-License-Identifier: MIT
#pragma once
#include <glm/mat3x3.hpp>

#include "mesh/mesh.h"

namespace edaha {

// Where a mesh goes in another one: place = shift + scale * turn * point. `turn` is a rotation.
struct MeshPlace {
    glm::dmat3 turn{1};
    double scale = 1;
    Vec3 shift{0};
};

// The least turn that takes the y axis to `direction`, of length 1.
glm::dmat3 turn_from_up(const Vec3& direction);

// Adds all of `more`: parts and materials are kept apart, names as they are. O(more).
void add_mesh(Mesh& mesh, const Mesh& more, const MeshPlace& place);

}  // namespace edaha
