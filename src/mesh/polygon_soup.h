// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "base/none.h"
#include "mesh/mesh.h"

namespace edaha {

// Faces as a file tells them, before they are a mesh.
struct PolygonSoup {
    struct Face {
        std::uint32_t corners = 0;
        std::uint32_t part = 0;
    };
    std::vector<Vec3> points;
    std::vector<glm::dvec2> uv;
    std::vector<std::uint32_t> corner_points;  // all faces' one after another
    std::vector<std::uint32_t> corner_uv;      // index into uv or kNone; may be shorter
    std::vector<Face> faces;
    std::vector<MeshPart> parts;
    std::vector<Material> materials;
};

// Triangles instead of polygons, points of each part on their own, parts and materials without
// faces left out, names of parts made unique ("root", "root-2"; "mesh" where there is none).
// Indices are in range. Corners without a place in (u,v) get (0, 0). Linear.
Mesh mesh_of(PolygonSoup soup);

}  // namespace edaha
