// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace edaha {

struct CornerNormals {
    std::vector<Vec3> normals;                     // of length 1; (0, 1, 0) where there is none
    std::vector<std::array<std::uint32_t, 3>> of;  // a triangle's corners: index into normals
};

// Normals for shading: corners at one point share one, the mean of their triangles' weighted by the
// angles there, if they hang together by edges whose triangles turn by `crease_rad` or less.
// O(n log n) at most.
CornerNormals corner_normals(const Mesh& mesh, double crease_rad);

}  // namespace edaha
