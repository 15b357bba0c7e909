// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "base/error.h"
#include "mesh/mesh.h"

namespace edaha {

struct MeshReadParams {
    bool weld = true;  // weld_open() of weld.h; many programs write a point once a normal
    std::size_t most_triangles = 20'000'000;
    std::size_t most_points = 60'000'000;
};

// What a file holds, and what of it is not kept. Parts come in the file's order, each with its own
// points, those in the order in which its faces name them; points that no face names are left out.
struct MeshInput {
    Mesh mesh;
    std::vector<Problem> warnings;
};

}  // namespace edaha
