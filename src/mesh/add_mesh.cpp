// SPDX-License-Identifier: MIT
#include "mesh/add_mesh.h"

#include <glm/geometric.hpp>

namespace edaha {

// Rodrigues' formula about the axis that is level and square to `direction`.
glm::dmat3 turn_from_up(const Vec3& direction) {
    const double cosine = direction.y;
    if (cosine < -1 + 1e-12) return glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1);
    const Vec3 axis(direction.z, 0, -direction.x);  // of the sine's length
    const double k = 1 / (1 + cosine);
    const glm::dmat3 square = glm::outerProduct(axis, axis) * k;
    return square +
           glm::dmat3(cosine, axis.z, -axis.y, -axis.z, cosine, axis.x, axis.y, -axis.x, cosine);
}

void add_mesh(Mesh& mesh, const Mesh& more, const MeshPlace& place) {
    const auto points = static_cast<std::uint32_t>(mesh.points.size());
    const auto parts = static_cast<std::uint32_t>(mesh.parts.size());
    const auto materials = static_cast<std::uint32_t>(mesh.materials.size());
    const auto placed = [&](const Vec3& p) { return place.shift + place.scale * (place.turn * p); };
    if (!mesh.uv.empty() || !more.uv.empty()) {
        mesh.uv.resize(mesh.triangles.size());
        mesh.uv.insert(mesh.uv.end(), more.uv.begin(), more.uv.end());
        mesh.uv.resize(mesh.triangles.size() + more.triangles.size());
    }
    for (const Vec3& point : more.points)
        mesh.points.push_back(placed(point));
    for (const Triangle& t : more.triangles)
        mesh.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
    for (const std::uint32_t part : more.part_of)
        mesh.part_of.push_back(part + parts);
    for (MeshPart part : more.parts) {
        part.material += materials;
        if (part.parent >= 0) part.parent += static_cast<std::int32_t>(parts);
        if (part.axis) part.axis = Axis{placed(part.axis->from), placed(part.axis->to)};
        mesh.parts.push_back(std::move(part));
    }
    mesh.materials.insert(mesh.materials.end(), more.materials.begin(), more.materials.end());
    for (SprigSite site : more.sites) {
        site.position = placed(site.position);
        site.direction = place.turn * site.direction;
        site.size *= place.scale;
        site.part += parts;
        mesh.sites.push_back(site);
    }
}

}  // namespace edaha
