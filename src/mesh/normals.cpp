// SPDX-License-Identifier: MIT
#include "mesh/normals.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "mesh/corner_groups.h"
#include "mesh/edges.h"
#include "mesh/facets.h"

namespace edaha {
namespace {

// Without length where the triangle has no area.
Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : Vec3(0);
}

double angle_at(const Mesh& mesh, const Triangle& t, std::size_t k) {
    const Vec3& tip = mesh.points[t[k]];
    const Vec3 a = unit(mesh.points[t[(k + 1) % 3]] - tip);
    const Vec3 b = unit(mesh.points[t[(k + 2) % 3]] - tip);
    return stable::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

CornerNormals corner_normals(const Mesh& mesh, double crease_rad) {
    const std::vector<std::uint32_t> group = group_corners(mesh, mesh_edges(mesh), crease_rad);
    CornerNormals result;
    result.of.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 facet = unit(facet_normal(mesh, t));
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t first = group[3 * t + k];  // never later than this corner
            std::uint32_t& normal = result.of[t][k];
            if (first == 3 * t + k) {
                normal = static_cast<std::uint32_t>(result.normals.size());
                result.normals.emplace_back(0);
            } else {
                normal = result.of[first / 3][first % 3];
            }
            result.normals[normal] += facet * angle_at(mesh, mesh.triangles[t], k);
        }
    }
    for (Vec3& normal : result.normals) {
        normal = unit(normal);
        if (normal == Vec3(0)) normal = {0, 1, 0};
    }
    return result;
}

}  // namespace edaha
