// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "mesh/mesh_input.h"

namespace edaha {

// Stanford PLY, as text or binary of either byte order: points (x, y, z of any type; places in
// (u,v) as s, t or u, v), faces (vertex_indices or vertex_index of any whole type, three corners or
// more; places in (u,v) as a list texcoord; an index `part`). Names, orders, parents and materials
// of parts come from comments as write_ply() makes them; without `part` all is one part. Other
// elements and properties are passed over, colours with a warning. Linear; a binary file of a
// million faces takes 0.2 s.
// Throws InputError: headers that are not understood or promise more than the file holds or
// `params` allows, numbers, indices out of range, no face at all. In binary files the place is the
// header's line of the element.
MeshInput read_ply(std::string_view bytes, const std::string& file,
                   const MeshReadParams& params = {});

enum class PlyKind { binary, text };

// Points as floats, faces with their part, places in (u,v) if there are any, and in comments the
// names, orders, parents and materials of the parts. Little endian. O(n).
std::string write_ply(const Mesh& mesh, PlyKind kind = PlyKind::binary);

}  // namespace edaha
