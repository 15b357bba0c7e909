// SPDX-License-Identifier: MIT
#include "app/model_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/obstacle_mesh.h"
#include "mesh/add_mesh.h"

namespace edaha {
namespace {

void add_roots(ModelMesh& model, const Style& style, const KeyedRandom& random) {
    const PropRoots roots = grow_prop_roots(style.prop_root, random);
    model.mesh = mesh_of(roots, style.prop_root);
    model.top = trunk_top(roots);
    model.roots = RootCounts{roots.roots.size(), roots.removed, roots.by_order};
    for (const PropRoot& root : roots.roots) {
        if (root.young) continue;
        model.root_feet.push_back(
            {root.at(root.length), root.radius_at(root.length, style.prop_root.knob)});
    }
}

// Of the circle round the first prism's base.
double foot_radius(const Mesh& prisms) {
    double radius = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, prisms.points.size()); ++i)
        radius = std::max(radius, glm::length(prisms.points[i]));
    return radius;
}

void add_prisms(ModelMesh& model, const Style& style, const KeyedRandom& random) {
    PrismTree tree = grow_prisms(style.prism, random);
    model.prisms = std::move(tree.counts);
    MeshPlace place;
    const double radius = foot_radius(tree.mesh);
    if (model.top && radius > 0) {
        place.turn = turn_from_up(model.top->direction);
        place.scale = model.top->radius / radius;
        place.shift = model.top->position;
    }
    add_mesh(model.mesh, tree.mesh, place);
}

}  // namespace

KeyedRandom random_of(const Style& style) {
    const VariantParams& variant = style.energy.variant;
    return {variant.family, variant.seed, variant.vary};
}

bool makes_mesh(const Style& style) {
    return std::ranges::any_of(style.models, [](Model model) { return model != Model::energy; });
}

ModelMesh model_of(const Style& style, SurfaceTree tree, std::int64_t step) {
    ModelMesh model;
    model.mesh = std::move(tree.mesh);
    model.surface = tree.report;
    // A mesh of one kind: all of it has (u,v), or nothing.
    if (!style.surface.obstacles.empty()) model.mesh.uv.resize(model.mesh.triangles.size());
    std::size_t number = 0;
    for (const SolidParams& obstacle : style.surface.obstacles) {
        Mesh solid = obstacle_mesh(obstacle, "obstacle-" + std::to_string(++number));
        solid.uv.resize(solid.triangles.size());
        if (obstacle.step <= step) add_mesh(model.mesh, solid, {});
    }
    return model;
}

ModelMesh make_model_mesh(const Style& style, const SurfaceWatch& watch) {
    if (has_model(style.models, Model::surface)) {
        SurfaceTree tree = grow_surface(style.surface, random_of(style), watch);
        return model_of(style, std::move(tree), style.surface.steps);
    }
    ModelMesh model;
    const KeyedRandom random = random_of(style);
    if (has_model(style.models, Model::prop_root)) add_roots(model, style, random);
    if (has_model(style.models, Model::prism)) add_prisms(model, style, random);
    return model;
}

}  // namespace edaha
