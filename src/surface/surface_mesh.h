// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "base/keyed_random.h"
#include "mesh/mesh.h"
#include "surface/apex.h"
#include "surface/growing_mesh.h"
#include "surface/surface_params.h"

namespace edaha {

// What has grown, as a mesh (Mizoguchi & Miyata 2014, section 9): one closed surface whose parts
// share the points between them. A part is a branch: "trunk", "branch-1"; a face of several
// belongs to the one that sprouted last, nearest to a tip. Faces with a vertex of xylem make parts
// of their own, "trunk-xylem", of the material "xylem".
//
// (u, v) in mm: v along the way of the branch's apex, u the angle about that way times the mean
// radius of the branch, less the winding, so that lines of constant u are lines of phloem. (A
// radius that follows the taper would shear them [E].) Corners of a face lie together: across the
// seam a point has two u. Places for twigs are growing tips, and random cambium near them: one in
// sprig_spacing_mm squared on average, between outwards and forwards (5.3) [E]. Branches that a
// rule has stopped are of the material "deadwood" if asked [E].
// O(faces + vertices x steps).
Mesh surface_mesh(const GrowingMesh& mesh, std::span<const Apex> apices,
                  const SurfaceParams& params, const KeyedRandom& random);

}  // namespace edaha
