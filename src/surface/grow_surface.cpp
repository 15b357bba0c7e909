// SPDX-License-Identifier: MIT
#include "surface/grow_surface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "surface/branch_way.h"
#include "surface/crossings.h"
#include "surface/surface_growth.h"
#include "surface/surface_mesh.h"

namespace edaha {

namespace {

constexpr std::size_t kWorthThreads = 2000;

// A vertex: whether it is at least `thick_mm` from the way of its branch.
std::vector<std::uint8_t> thick_vertices(const SurfaceGrowth& growth, double thick_mm) {
    const GrowingMesh& mesh = growth.mesh();
    std::vector<std::optional<BranchWay>> ways(growth.apices().size());
    for (std::size_t b = 0; b < ways.size(); ++b)
        if (!growth.apices()[b].path.empty()) ways[b].emplace(growth.apices()[b]);
    std::vector<std::uint8_t> is_thick(mesh.position.size(), 0);
    for_each_index(is_thick.size(), kWorthThreads, [&](std::size_t v) {
        const auto& way = ways[mesh.branch[v]];
        is_thick[v] = mesh.is_vertex(static_cast<std::uint32_t>(v)) && way &&
                      way->place(mesh.position[v]).radius >= thick_mm;
    });
    return is_thick;
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
    tree.report.edges = edge_report(growth, params);
    return tree;
}

}  // namespace

EdgeReport edge_report(const SurfaceGrowth& growth, const SurfaceParams& params) {
    const GrowingMesh& mesh = growth.mesh();
    const std::vector<std::uint8_t> is_thick = thick_vertices(growth, params.merge_mm);
    EdgeReport report;
    std::size_t edges = 0, fitting = 0, thick_fitting = 0;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h) {
        if (mesh.origin[h] == kNone || mesh.twin[h] < h) continue;
        const std::uint32_t a = mesh.origin[h], b = mesh.target(h);
        const double length = glm::distance(mesh.position[a], mesh.position[b]);
        const bool fits = length >= params.merge_mm && length <= params.split_mm;
        ++edges;
        fitting += fits;
        report.longest_mm = std::max(report.longest_mm, length);
        if (is_thick[a] == 0 || is_thick[b] == 0) continue;
        ++report.thick;
        thick_fitting += fits;
    }
    if (edges > 0) report.in_range = double(fitting) / double(edges);
    if (report.thick > 0) report.thick_in_range = double(thick_fitting) / double(report.thick);
    return report;
}

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
