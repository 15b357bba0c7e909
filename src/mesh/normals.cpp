// SPDX-License-Identifier: MIT
#include "mesh/normals.h"

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "mesh/edges.h"

namespace edaha {
namespace {

// Without length where the triangle has no area.
Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : Vec3(0);
}

std::vector<Vec3> facet_normals(const Mesh& mesh) {
    std::vector<Vec3> normals;
    normals.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Vec3& origin = mesh.points[t[0]];
        normals.push_back(unit(glm::cross(mesh.points[t[1]] - origin, mesh.points[t[2]] - origin)));
    }
    return normals;
}

// Corners (3 t + k) that share a normal; the lowest stands for all.
class CornerSets {
  public:
    explicit CornerSets(std::size_t corners) : parent_(corners) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    std::uint32_t find(std::uint32_t corner) {
        while (parent_[corner] != corner)
            corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }

    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

std::uint32_t corner_at(const Mesh& mesh, std::uint32_t triangle, std::uint32_t point) {
    const Triangle& t = mesh.triangles[triangle];
    return 3 * triangle + (t[0] == point ? 0U : t[1] == point ? 1U : 2U);
}

double angle_at(const Mesh& mesh, const Triangle& t, std::size_t k) {
    const Vec3& tip = mesh.points[t[k]];
    const Vec3 a = unit(mesh.points[t[(k + 1) % 3]] - tip);
    const Vec3 b = unit(mesh.points[t[(k + 2) % 3]] - tip);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

CornerNormals corner_normals(const Mesh& mesh, double crease_rad) {
    const std::vector<Vec3> facets = facet_normals(mesh);
    const double least_cosine = std::cos(crease_rad);
    CornerSets sets(3 * mesh.triangles.size());
    for (const MeshEdge& edge : mesh_edges(mesh)) {
        if (edge.left == kNone || edge.right == kNone) continue;
        if (glm::dot(facets[edge.left], facets[edge.right]) < least_cosine) continue;
        for (const std::uint32_t point : {edge.a, edge.b})
            sets.unite(corner_at(mesh, edge.left, point), corner_at(mesh, edge.right, point));
    }
    CornerNormals result;
    result.of.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t first = sets.find(3 * t + k);  // never later than this corner
            std::uint32_t& normal = result.of[t][k];
            if (first == 3 * t + k) {
                normal = static_cast<std::uint32_t>(result.normals.size());
                result.normals.emplace_back(0);
            } else {
                normal = result.of[first / 3][first % 3];
            }
            result.normals[normal] += facets[t] * angle_at(mesh, mesh.triangles[t], k);
        }
    }
    for (Vec3& normal : result.normals) {
        normal = unit(normal);
        if (normal == Vec3(0)) normal = {0, 1, 0};
    }
    return result;
}

}  // namespace edaha
