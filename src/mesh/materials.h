// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <string_view>

#include "base/colour.h"
#include "mesh/mesh.h"

namespace edaha {

// Diffuse colours (Kd, taken as sRGB) of a Wavefront MTL file, by material. Lines that are no such
// thing, or broken, are passed over: a colour can do without them.
std::map<std::string, Colour> read_material_colours(std::string_view text);

// The MTL file of a mesh's materials.
std::string material_text(const Mesh& mesh);

}  // namespace edaha
