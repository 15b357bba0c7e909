// SPDX-License-Identifier: MIT
#include "surface/grow_surface.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

#include "surface/crossings.h"
#include "surface/surface_growth.h"
#include "surface/surface_mesh.h"

namespace edaha {

namespace {

void measure_edges(const GrowingMesh& mesh, const SurfaceParams& params, SurfaceReport& report) {
    std::size_t edges = 0, in_range = 0;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h) {
        if (mesh.origin[h] == kNone || mesh.twin[h] < h) continue;
        const double length =
            glm::distance(mesh.position[mesh.origin[h]], mesh.position[mesh.target(h)]);
        ++edges;
        if (length >= params.merge_mm && length <= params.split_mm) ++in_range;
        report.longest_edge_mm = std::max(report.longest_edge_mm, length);
    }
    if (edges > 0)
        report.edges_in_range = static_cast<double>(in_range) / static_cast<double>(edges);
}

SurfaceTree tree_of(const SurfaceGrowth& growth, const SurfaceParams& params,
                    const KeyedRandom& random) {
    SurfaceTree tree{surface_mesh(growth.mesh(), growth.apices(), params, random), growth.report()};
    tree.report.steps = growth.steps();
    tree.report.vertices = growth.mesh().vertices();
    tree.report.faces = growth.mesh().faces();
    tree.report.branches = static_cast<std::size_t>(
        std::count_if(growth.apices().begin(), growth.apices().end(),
                      [](const Apex& apex) { return !apex.path.empty(); }));
    tree.report.contacts = growth.fields().contacts();
    tree.report.deepest_mm = growth.fields().deepest_mm(growth.mesh());
    tree.report.crossing_pairs = crossing_faces(growth.mesh()).size();
    measure_edges(growth.mesh(), params, tree.report);
    return tree;
}

}  // namespace

SurfaceTree grow_surface(const SurfaceParams& params, const KeyedRandom& random,
                         const SurfaceWatch& watch) {
    const auto start = std::chrono::steady_clock::now();
    SurfaceGrowth growth(params, random);
    for (std::int64_t step = 1; step <= params.steps; ++step) {
        growth.step();
        if (watch.progress) watch.progress(step, growth.mesh().faces());
        if (watch.frame && watch.wants && watch.wants(step))
            watch.frame(step, tree_of(growth, params, random));
    }
    SurfaceTree tree = tree_of(growth, params, random);
    tree.report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return tree;
}

}  // namespace edaha
