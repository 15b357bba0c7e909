// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "mesh/mesh.h"

namespace edaha {

// An upright sheet in the plane z, its (u,v) the places on it, in two triangles, facing the front.
inline void add_sheet(Mesh& mesh, Vec2 min, Vec2 max, double z) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const Vec2 corners[] = {min, {max.x, min.y}, max, {min.x, max.y}};
    for (const Vec2 c : corners)
        mesh.points.push_back({c.x, c.y, z});
    for (const auto& [a, b, c] : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.uv.push_back({corners[a], corners[b], corners[c]});
        mesh.part_of.push_back(static_cast<std::uint32_t>(mesh.parts.size()));
    }
    mesh.parts.push_back({"sheet-" + std::to_string(mesh.parts.size()), 0, -1, 0, {}});
}

}  // namespace edaha
