// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace edaha {

// What PLY has no place for, as comments of its header, one a material and one a part:
//   material 0 8a6b4c wood
//   part 3 1 0 0 root-3      (its order, parent and material; -1: no parent)
// A colour may be `none`.
struct PlyNotes {
    std::vector<Material> materials;
    std::vector<MeshPart> parts;
};

// Comments that are no such notes, or don't come in order from 0, are passed over.
PlyNotes read_ply_notes(const std::vector<std::string>& comments);

// Lines "comment ..." with their ends.
std::string ply_notes(const Mesh& mesh);

}  // namespace edaha
