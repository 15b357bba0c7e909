// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/mesh_input.h"

namespace edaha {

// The text of a material file (mtllib) by its name as it is written; none if it can't be had.
using LoadMaterials = std::function<std::optional<std::string>(const std::string& name)>;

// Wavefront OBJ: points, places in (u,v) and faces of three corners or more; a part is what one o
// and g name and one material (usemtl) share. Diffuse colours (Kd) become the materials'. Normals,
// smoothing groups, lines and single points are left out, and what is not known with a warning.
// Both kinds of indices, continued lines, LF, CR LF and CR. Linear; a million faces (40 MB) take
// 0.2 s. Throws InputError (the first ten problems): numbers, indices that are out of range, no
// face at all, more than `params` allows.
MeshInput read_obj(std::string_view text, const std::string& file,
                   const MeshReadParams& params = {}, const LoadMaterials& load_materials = {});

struct ObjText {
    std::string obj;
    std::string mtl;  // empty if `materials_file` is
};

// Parts as groups, with places in (u,v) if there are any, and normals: smooth where triangles meet
// at less than 50 degrees. Nine digits, so a float is read back as the same. The materials' file is
// named by `materials_file`; with "" there are none. O(n).
ObjText write_obj(const Mesh& mesh, const std::string& materials_file);

}  // namespace edaha
