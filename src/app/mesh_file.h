// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "mesh/mesh_input.h"

namespace edaha {

enum class MeshFormat { obj, ply };

// By its ending, small or capital letters.
std::optional<MeshFormat> mesh_format_of_file(const std::string& file);

// A mesh and the fingerprint of all that it was read from.
struct MeshFile {
    MeshInput input;
    std::string fingerprint;
};

// Reads a file of up to 4 GiB; PLY files are known by how they begin. Materials are looked for in
// its own folder alone. Errors: InputError and IoError; UsageError for other endings.
MeshFile read_mesh_file(const std::string& file);

}  // namespace edaha
