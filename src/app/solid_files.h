// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "style/style.h"

namespace edaha {

// The style with the meshes of the files that its obstacles and hollows name, each file read once:
// welded, of one part, with the outside outside. Errors: InputError and IoError as for the files
// themselves, InputError for a mesh that bounds no solid.
Style with_solid_files(Style style);

// What those hold, for fingerprints.
std::vector<std::string> solid_bytes(const SurfaceParams& params);

}  // namespace edaha
