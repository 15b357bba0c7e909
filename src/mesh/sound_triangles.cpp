// SPDX-License-Identifier: MIT
#include "mesh/sound_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/mesh_check.h"
#include "mesh/pieces.h"

namespace edaha {
namespace {

// Its points from the lowest on.
Triangle turned_to_lowest(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

}  // namespace

bool is_sound(const Vec3& point) {
    return std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest &&
           std::abs(point.z) <= kFarthest;
}

bool has_all(const Mesh& mesh, std::size_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    return std::max({t[0], t[1], t[2]}) < mesh.points.size() &&
           mesh.part_of[triangle] < mesh.parts.size();
}

bool is_sound(const Mesh& mesh, std::size_t triangle) {
    if (!has_all(mesh, triangle)) return false;
    const Triangle& t = mesh.triangles[triangle];
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t point) { return is_sound(mesh.points[point]); });
}

std::vector<std::uint32_t> find_double_triangles(const Mesh& mesh,
                                                 std::span<const MeshEdge> edges) {
    std::vector<std::uint32_t> candidates;
    for_each_edge_use(edges, [&](const SideUse& use) {
        if (std::max(use.left, use.right) < 2) return;
        for (const MeshEdge& edge : use.edges) {
            for (const std::uint32_t t : {edge.left, edge.right}) {
                if (t != kNone) candidates.push_back(t);
            }
        }
    });
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    std::vector<std::pair<Triangle, std::uint32_t>> sorted;
    sorted.reserve(candidates.size());
    for (const std::uint32_t t : candidates)
        sorted.emplace_back(turned_to_lowest(mesh.triangles[t]), t);
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint32_t> doubles;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first == sorted[i - 1].first) doubles.push_back(sorted[i].second);
    }
    std::sort(doubles.begin(), doubles.end());
    return doubles;
}

}  // namespace edaha
