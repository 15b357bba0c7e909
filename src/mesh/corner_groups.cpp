// SPDX-License-Identifier: MIT
#include "mesh/corner_groups.h"

#include "base/disjoint_sets.h"
#include "mesh/facets.h"

namespace edaha {
namespace {

std::uint32_t corner_at(const Mesh& mesh, std::uint32_t triangle, std::uint32_t point) {
    const Triangle& t = mesh.triangles[triangle];
    return 3 * triangle + (t[0] == point ? 0U : t[1] == point ? 1U : 2U);
}

}  // namespace

std::vector<std::uint32_t> group_corners(const Mesh& mesh, std::span<const MeshEdge> edges,
                                         double crease_rad) {
    const FacetAngle crease(crease_rad);
    DisjointSets sets(3 * mesh.triangles.size());
    for (const MeshEdge& edge : edges) {
        if (edge.left == kNone || edge.right == kNone || crease.is_sharp(mesh, edge)) continue;
        for (const std::uint32_t point : {edge.a, edge.b})
            sets.unite(corner_at(mesh, edge.left, point), corner_at(mesh, edge.right, point));
    }
    std::vector<std::uint32_t> group(3 * mesh.triangles.size());
    for (std::uint32_t corner = 0; corner < group.size(); ++corner)
        group[corner] = sets.find(corner);
    return group;
}

}  // namespace edaha
