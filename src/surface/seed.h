// SPDX-License-Identifier: MIT
#pragma once
#include "surface/growing_mesh.h"
#include "surface/surface_params.h"

namespace edaha {

// The start (section 4.1): a prism with a cone on it, its foot on the ground round the origin, its
// one apex at the top, the last vertex. Lines of phloem run up its edges to the apex (6.3).
GrowingMesh seed_mesh(const SurfaceParams& params);

}  // namespace edaha
