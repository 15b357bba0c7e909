// SPDX-License-Identifier: MIT
#include "surface/seed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/stable_math.h"

namespace edaha {

GrowingMesh seed_mesh(const SurfaceParams& params) {
    const auto sides = static_cast<std::uint32_t>(params.sides);
    const auto rings = static_cast<std::uint32_t>(
        std::max(1.0, std::ceil(params.seed_height_mm / params.split_mm)));
    std::vector<Vec3> points;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        const double part = static_cast<double>(ring) / rings;
        for (std::uint32_t side = 0; side < sides; ++side) {
            const auto turn = stable::sin_cos(2 * std::numbers::pi * side / sides);
            const double radius = params.seed_radius_mm * (1 - part * part);
            points.emplace_back(radius * turn.sin, params.seed_height_mm * part, radius * turn.cos);
        }
    }
    const auto foot = static_cast<std::uint32_t>(points.size()), apex = foot + 1;
    points.emplace_back(0, 0, 0);
    points.emplace_back(0, params.seed_height_mm, 0);
    std::vector<Triangle> triangles;
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t after = (side + 1) % sides, top = (rings - 1) * sides;
        triangles.push_back({foot, after, side});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t low = ring * sides, high = low + sides;
            triangles.push_back({low + side, low + after, high + after});
            triangles.push_back({low + side, high + after, high + side});
        }
        triangles.push_back({top + side, top + after, apex});
    }
    GrowingMesh mesh = growing_mesh(points, triangles);
    for (std::uint32_t i = 0; i < rings * sides; ++i) {
        const bool is_last = i >= (rings - 1) * sides;
        mesh.phloem_up[i] = is_last ? apex : i + sides;
        if (!is_last) mesh.phloem_down[i + sides] = i;
    }
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        mesh.thickening[v] = params.thickening_mm;
        mesh.travel[v] = mesh.position[v].y - params.seed_height_mm;
    }
    mesh.tissue[apex] = Tissue::apex;
    return mesh;
}

}  // namespace edaha
