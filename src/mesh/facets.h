// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "mesh/edges.h"
#include "mesh/mesh.h"

namespace edaha {

// Outwards, as long as twice the triangle's area.
inline Vec3 facet_normal(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

// Tells edges whose triangles' normals are further apart than an angle. Without roots.
class FacetAngle {
  public:
    explicit FacetAngle(double angle_rad) : cos_(stable::sin_cos(angle_rad).cos) {}

    // The edge has both its triangles. One without an area makes no sharp edges.
    bool is_sharp(const Mesh& mesh, const MeshEdge& edge) const {
        const Vec3 n = facet_normal(mesh, edge.left), m = facet_normal(mesh, edge.right);
        const double product = glm::dot(n, m);
        const double lengths = glm::dot(n, n) * glm::dot(m, m);
        return product * std::abs(product) < cos_ * std::abs(cos_) * lengths;
    }

  private:
    double cos_;
};

}  // namespace edaha
