// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "mesh/mesh.h"
#include "surface/surface_params.h"

namespace edaha {

// An obstacle as it is drawn: closed, of one part (a wire: a part a rod), of the material
// "obstacle". A plane is not drawn: empty. In mm, y up, as the tree.
Mesh obstacle_mesh(const SolidParams& obstacle, const std::string& name);

}  // namespace edaha
