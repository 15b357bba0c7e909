// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "surface/apex.h"
#include "surface/collisions.h"
#include "surface/growing_mesh.h"

namespace edaha {

using BarsFace = std::function<bool(const Vec3&, const Vec3&, const Vec3&)>;

// Sews the surface round a to that round b, which looks at it: both vertices go with their faces,
// and a tube of the shortest diagonals joins the two loops that are left (spec: section 9). Where
// the loops were of one surface it gets a handle, where of two these become one. Lines of phloem
// end there. False, and nothing done, if the loops share or join vertices, if the tube
// would stand the wrong way round or pass through something, or a face be barred.
struct SewLimits {
    BarsFace is_barred;              // whether a face may not lie there
    const FaceGrid* grid = nullptr;  // of the mesh: no new face passes through one that was in it
};
bool sew(GrowingMesh& mesh, std::uint32_t a, std::uint32_t b, const SewLimits& limits = {});

struct Fusions {
    std::size_t sewn = 0;
    std::size_t pinned = 0;  // vertices that met something but could not be sewn this time
};

// Merges vertices that meet a face within this step with a corner of that face [P 5.3]: the
// nearest pairs first, each apex that meets something stops. Buds, centres of burls, xylem and
// what stands on the ground are pinned instead. The pairs' faces and vertices are no longer what
// they were, if any were sewn.
Fusions fuse_facing(GrowingMesh& mesh, std::vector<Apex>& apices, std::span<const FacingPair> pairs,
                    std::span<const Vec3> normals, const SewLimits& limits = {});

}  // namespace edaha
