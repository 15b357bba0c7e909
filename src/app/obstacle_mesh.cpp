// SPDX-License-Identifier: MIT
#include "app/obstacle_mesh.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "mesh/add_mesh.h"
#include "proproot/tube.h"
#include "surface/solids.h"

namespace edaha {
namespace {

// Enough for a round outline: a corner of a 24-gon is off by a hundredth of the radius.
constexpr int kPoints = 24;
constexpr int kRings = 6;  // of a round end

// A rod with half spheres at its ends; a ball if both ends are one.
void add_rod(Mesh& mesh, const std::string& name, const SolidParams& rod) {
    const Vec3 way = rod.to - rod.from;
    const double length = rod.shape == SolidShape::ball ? 0 : glm::length(way);
    const Vec3 axis = length > 0 ? way / length : Vec3(0, 1, 0);
    std::vector<TubeCircle> circles;
    for (int i = 0; i < 2 * kRings; ++i) {
        // Not quite from pole to pole: a circle has a radius.
        const double turn = std::numbers::pi * ((i + 0.5) / (2 * kRings) - 0.5);
        const auto [s, c] = stable::sin_cos(turn);
        const double along = rod.radius_mm * s + (i < kRings ? 0 : length);
        circles.push_back({rod.from + axis * along, axis, rod.radius_mm * c, along});
    }
    TubeParams params;
    params.points = kPoints;
    add_tube(mesh, {name, 0, -1, 0, {}}, circles, params);
}

void add_box(Mesh& mesh, const std::string& name, const SolidParams& box) {
    const Vec3 low = glm::min(box.from, box.to), high = glm::max(box.from, box.to);
    for (int i = 0; i < 8; ++i) {
        mesh.points.push_back({(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                               (i & 4) != 0 ? high.z : low.z});
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    mesh.part_of.assign(mesh.triangles.size(), 0);
    mesh.parts.push_back({name, 0, -1, 0, {}});
}

void add_wire(Mesh& mesh, const std::string& name, const SolidParams& wire) {
    const std::vector<Vec3> corners = wire_corners(wire);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        SolidParams rod = wire;
        rod.shape = SolidShape::rod;
        rod.from = corners[i];
        rod.to = corners[i + 1];
        add_rod(mesh, name + '-' + std::to_string(i + 1), rod);
    }
}

void add_from_file(Mesh& mesh, const std::string& name, const SolidParams& solid) {
    if (!solid.mesh) return;
    MeshPlace place;
    place.shift = solid.from;
    add_mesh(mesh, *solid.mesh, place);
    mesh.uv.clear();
    mesh.part_of.assign(mesh.triangles.size(), 0);
    mesh.parts = {{name, 0, -1, 0, {}}};
}

}  // namespace

Mesh obstacle_mesh(const SolidParams& obstacle, const std::string& name) {
    Mesh mesh;
    switch (obstacle.shape) {
        case SolidShape::plane:
            return mesh;
        case SolidShape::box:
            add_box(mesh, name, obstacle);
            break;
        case SolidShape::ball:
        case SolidShape::rod:
            add_rod(mesh, name, obstacle);
            break;
        case SolidShape::wire:
            add_wire(mesh, name, obstacle);
            break;
        case SolidShape::mesh:
            add_from_file(mesh, name, obstacle);
            break;
    }
    mesh.materials = {{"obstacle", {}}};
    return mesh;
}

}  // namespace edaha
