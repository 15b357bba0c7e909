// SPDX-License-Identifier: MIT
#include "app/solid_files.h"

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/mesh_file.h"
#include "mesh/mesh_check.h"
#include "mesh/weld.h"

namespace edaha {
namespace {

using SharedMesh = std::shared_ptr<const Mesh>;

constexpr double kNoVolume = 1e-9;  // sheets laid double, to rounding; a wire has more

[[noreturn]] void refuse(const std::string& file, std::string message) {
    throw InputError(std::vector<Problem>{{{file, 0, 0}, std::move(message)}});
}

// Where groups of a file meet, they have points of their own: they close only as one part.
Mesh as_one_part(Mesh mesh) {
    mesh.uv.clear();
    mesh.sites.clear();
    mesh.parts.resize(1);
    mesh.parts[0] = {"solid", 0, -1, 0, {}};
    mesh.materials = {{"solid", {}}};
    mesh.part_of.assign(mesh.triangles.size(), 0);
    weld_open(mesh);
    return mend(std::move(mesh));
}

// Of what is wrong with a mesh only what leaves open where its inside is.
std::vector<std::string> leaks(const Mesh& mesh) {
    const MeshReport all = validate(mesh);
    MeshReport report;
    report.open_edges = all.open_edges;
    report.crowded_edges = all.crowded_edges;
    report.turned_edges = all.turned_edges;
    return report.lines();
}

// In parts of the cube of its size.
double volume_share(const Mesh& mesh) {
    double six_volumes = 0;
    Vec3 low = mesh.points.front(), high = low;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 from = mesh.points[a] - mesh.points.front();
        six_volumes += glm::dot(from, glm::cross(mesh.points[b] - mesh.points.front(),
                                                 mesh.points[c] - mesh.points.front()));
        for (const std::uint32_t v : {a, b, c}) {
            low = glm::min(low, mesh.points[v]);
            high = glm::max(high, mesh.points[v]);
        }
    }
    const double size = glm::distance(low, high);
    return size > 0 ? std::abs(six_volumes) / (6 * size * size * size) : 0;
}

SharedMesh read_solid(const std::string& file) {
    if (!mesh_format_of_file(file)) refuse(file, "the ending is no mesh (expected obj or ply)");
    Mesh mesh = as_one_part(read_mesh_file(file).input.mesh);
    if (mesh.triangles.empty()) refuse(file, "the mesh bounds no solid: it has no triangles");
    const std::vector<std::string> wrong = leaks(mesh);
    if (!wrong.empty())
        refuse(file, fmt::format("the mesh bounds no solid: {}", fmt::join(wrong, ", ")));
    if (volume_share(mesh) < kNoVolume) refuse(file, "the mesh bounds no solid: it has no volume");
    return std::make_shared<const Mesh>(std::move(mesh));
}

template <class Item>
std::string bytes_of(const std::vector<Item>& items) {
    const char* const begin = reinterpret_cast<const char*>(items.data());
    return {begin, begin + items.size() * sizeof(Item)};
}

}  // namespace

Style with_solid_files(Style style) {
    std::map<std::string, SharedMesh> meshes;
    for (std::vector<SolidParams>* solids : {&style.surface.hollows, &style.surface.obstacles}) {
        for (SolidParams& solid : *solids) {
            if (solid.file.empty()) continue;
            SharedMesh& mesh = meshes[solid.file];
            if (!mesh) mesh = read_solid(solid.file);
            solid.mesh = mesh;
        }
    }
    return style;
}

std::vector<std::string> solid_bytes(const SurfaceParams& params) {
    std::vector<std::string> bytes;
    for (const std::vector<SolidParams>* solids : {&params.hollows, &params.obstacles}) {
        for (const SolidParams& solid : *solids) {
            if (!solid.mesh) continue;
            bytes.push_back(bytes_of(solid.mesh->points));
            bytes.push_back(bytes_of(solid.mesh->triangles));
        }
    }
    return bytes;
}

}  // namespace edaha
