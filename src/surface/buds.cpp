// SPDX-License-Identifier: MIT
#include "surface/buds.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace edaha {

namespace {

// Within two edges, without the vertex itself; sorted.
std::vector<std::uint32_t> two_rings(const GrowingMesh& mesh, std::uint32_t v) {
    std::vector<std::uint32_t> found;
    mesh.for_each_out(v, [&](std::uint32_t h) {
        const std::uint32_t near = mesh.target(h);
        found.push_back(near);
        mesh.for_each_out(near, [&](std::uint32_t g) { found.push_back(mesh.target(g)); });
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::erase(found, v);
    return found;
}

// Ends the lines of phloem that run through v: the upper ones always, those from below on demand.
void end_lines(GrowingMesh& mesh, std::uint32_t v) {
    const std::uint32_t up = mesh.phloem_up[v];
    if (up != kNone && mesh.phloem_down[up] == v) mesh.phloem_down[up] = kNone;
    mesh.phloem_up[v] = kNone;
    mesh.phloem_down[v] = kNone;
}

}  // namespace

std::optional<std::uint32_t> bud_vertex(const GrowingMesh& mesh, std::span<const Vec3> normals,
                                        std::uint32_t apex, const Vec3& direction) {
    std::optional<std::uint32_t> best;
    double most = 0;
    for (const std::uint32_t v : two_rings(mesh, apex)) {
        if (mesh.tissue[v] != Tissue::cambium || mesh.is_bud[v] != 0) continue;
        const double cosine = glm::dot(normals[v], direction);
        if (best && cosine <= most) continue;
        best = v;
        most = cosine;
    }
    return best;
}

void sprout(GrowingMesh& mesh, std::vector<Apex>& apices, std::uint32_t branch) {
    Apex& apex = apices[branch];
    const std::uint32_t v = apex.vertex;
    end_lines(mesh, v);
    mesh.tissue[v] = Tissue::apex;
    mesh.is_bud[v] = 0;
    mesh.branch[v] = branch;
    mesh.thickening[v] = apex.state.thickening_mm;
    mesh.travel[v] = 0;
    apex.grows = true;
    apex.path.push_back(mesh.position[v]);
    apex.travels.push_back(0);
}

void stop_apex(GrowingMesh& mesh, Apex& apex) {
    const std::uint32_t v = apex.vertex;
    mesh.tissue[v] = Tissue::cambium;
    mesh.thickening[v] = apex.state.thickening_mm;
    mesh.for_each_out(v, [&](std::uint32_t h) {
        if (mesh.phloem_up[mesh.target(h)] == v) mesh.phloem_up[mesh.target(h)] = kNone;
    });
    apex.grows = false;
}

}  // namespace edaha
