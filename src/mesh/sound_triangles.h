// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/edges.h"

namespace edaha {

// What both validate() and mend() of mesh_check.h ask.

bool is_sound(const Vec3& point);                      // finite, not beyond kFarthest
bool has_all(const Mesh& mesh, std::size_t triangle);  // its points and its part exist
bool is_sound(const Mesh& mesh, std::size_t triangle);

// Triangles, in their order, that have the points of an earlier one in the same direction.
// `edges` are mesh_edges(mesh). Linear but for those on edges that are used twice in a direction.
std::vector<std::uint32_t> find_double_triangles(const Mesh& mesh, std::span<const MeshEdge> edges);

// Keeps the triangles for which keep(index) holds, in their order.
template <typename Keep>
void keep_triangles(Mesh& mesh, const Keep& keep) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!keep(t)) continue;
        mesh.triangles[kept] = mesh.triangles[t];
        mesh.part_of[kept] = mesh.part_of[t];
        if (!mesh.uv.empty()) mesh.uv[kept] = mesh.uv[t];
        ++kept;
    }
    mesh.triangles.resize(kept);
    mesh.part_of.resize(kept);
    if (!mesh.uv.empty()) mesh.uv.resize(kept);
}

}  // namespace edaha
