// SPDX-License-Identifier: MIT
#include "proproot/prop_root_mesh.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "proproot/root_line.h"
#include "proproot/tube.h"

namespace edaha {
namespace {

enum RootMaterial : std::uint32_t { kTrunkMaterial, kRootMaterial };

// What the thesis' figures paint roots of each order in.
constexpr Colour kOrderColours[] = {{0xc9, 0x4b, 0x3a},
                                    {0xdd, 0x8a, 0x3c},
                                    {0xe9, 0xc9, 0x55},
                                    {0xf1, 0xe7, 0xc0},
                                    {0xfa, 0xf8, 0xf2}};

std::vector<Material> materials(const PropRootParams& params) {
    std::vector<Material> result{{"trunk", std::nullopt}, {"root", std::nullopt}};
    if (!params.order_colours) return result;
    result.pop_back();
    for (const Colour colour : kOrderColours)
        result.push_back({"root-order-" + std::to_string(result.size()), colour});
    return result;
}

std::uint32_t material_of(const PropRoot& root, const PropRootParams& params) {
    return params.order_colours ? kRootMaterial + root.order - 1 : kRootMaterial;
}

double round(double radius) {
    return 2 * std::numbers::pi * radius;
}

// Each circle faces from its neighbour before to the one behind.
std::vector<TubeCircle> circles_along(const std::vector<LinePoint>& line) {
    std::vector<TubeCircle> circles;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto way = [&](std::size_t from) {
            return glm::normalize(line[from + 1].position - line[from].position);
        };
        const std::size_t last = line.size() - 1;
        const Vec3 normal = i == 0      ? way(0)
                            : i == last ? way(last - 1)
                                        : glm::normalize(way(i - 1) + way(i));
        circles.push_back({line[i].position, normal, line[i].radius, line[i].along});
    }
    return circles;
}

void add_trunk(Mesh& mesh, const Trunk& trunk, const PropRootParams& params) {
    std::vector<TubeCircle> circles;
    const int steps = std::max(params.curve_points / 2, 4);
    for (int i = 0; i <= steps; ++i) {
        const double y = trunk.height * i / steps;
        circles.push_back({trunk.centre(y), trunk.direction(y), trunk.radius(y), y});
    }
    // Twice as fat as a root, twice as many points.
    const TubeParams tube{2 * params.circle_points, false, false, round(trunk.foot_radius)};
    add_tube(mesh, {"trunk", 0, -1, kTrunkMaterial, std::nullopt}, circles, tube);
}

}  // namespace

Mesh mesh_of(const PropRoots& roots, const PropRootParams& params) {
    Mesh mesh;
    mesh.materials = materials(params);
    add_trunk(mesh, roots.trunk, params);
    for (const PropRoot& root : roots.roots) {
        const TubeParams tube{params.circle_points, !root.young, root.young, round(root.radius)};
        // The trunk is part 0.
        MeshPart part{roots.name_of(root), root.order, root.parent + 1, material_of(root, params),
                      std::nullopt};
        std::vector<TubeCircle> circles = circles_along(root_line(root, params));
        if (tube.grounded) circles.back().centre.y = 0;  // but for rounding
        add_tube(mesh, std::move(part), circles, tube);
    }
    return mesh;
}

TrunkTop trunk_top(const PropRoots& roots) {
    const Trunk& trunk = roots.trunk;
    return {trunk.centre(trunk.height), trunk.direction(trunk.height), trunk.radius(trunk.height)};
}

}  // namespace edaha
