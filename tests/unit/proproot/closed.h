// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/mesh.h"

namespace edaha::test {

// Whether each edge of a triangle is another one's of the same part, the other way round, and no
// third one's.
inline bool parts_are_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> part_of_edge;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::pair edge(t[k], t[(k + 1) % 3]);
            if (!part_of_edge.emplace(edge, mesh.part_of[i]).second) return false;
        }
    }
    for (const auto& [edge, part] : part_of_edge) {
        const auto back = part_of_edge.find({edge.second, edge.first});
        if (back == part_of_edge.end() || back->second != part) return false;
    }
    return true;
}

// What each part encloses; positive when it faces outwards.
inline std::vector<double> volumes(const Mesh& mesh) {
    std::vector<double> result(mesh.parts.size(), 0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const Vec3 normal = glm::cross(mesh.points[b], mesh.points[c]);
        result[mesh.part_of[i]] += glm::dot(mesh.points[a], normal) / 6;
    }
    return result;
}

}  // namespace edaha::test
