// SPDX-License-Identifier: MIT
#include "mesh/mesh_check.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/pieces.h"
#include "mesh/sound_triangles.h"

namespace edaha {
namespace {

// Twice the area against the longest side's square.
bool is_flat(const Mesh& mesh, const Triangle& t) {
    const Vec3 a = mesh.points[t[1]] - mesh.points[t[0]];
    const Vec3 b = mesh.points[t[2]] - mesh.points[t[0]];
    const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a)});
    return glm::length(glm::cross(a, b)) <= 1e-12 * longest;
}

std::size_t count_shared_points(const Mesh& mesh) {
    std::vector<std::uint32_t> owner(mesh.points.size(), kNone);
    std::vector<std::uint8_t> is_shared(mesh.points.size(), 0);
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t point : mesh.triangles[t]) {
            if (owner[point] == kNone) owner[point] = mesh.part_of[t];
            if (owner[point] == mesh.part_of[t] || is_shared[point] != 0) continue;
            is_shared[point] = 1;
            ++count;
        }
    }
    return count;
}

void count_edges(std::span<const MeshEdge> edges, MeshReport& report) {
    for_each_edge_use(edges, [&](const SideUse& use) {
        report.open_edges += use.triangles() == 1 ? 1 : 0;
        report.crowded_edges += use.triangles() > 2 ? 1 : 0;
        report.turned_edges += use.is_turned() ? 1 : 0;
    });
}

void count_pieces(const Mesh& mesh, std::span<const MeshEdge> edges, MeshReport& report) {
    const Pieces pieces = find_pieces(mesh, edges);
    std::vector<std::uint8_t> is_mixed(mesh.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        is_mixed[pieces.root[t]] |= pieces.is_turned[t];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (pieces.root[t] != t) continue;
        ++report.pieces;
        const bool inverted = pieces.is_closed[t] != 0 && is_mixed[t] == 0 && pieces.volume[t] < 0;
        report.inverted_pieces += inverted ? 1 : 0;
    }
}

void count_sound(const Mesh& mesh, MeshReport& report) {
    for (const Triangle& triangle : mesh.triangles)
        report.flat_triangles += is_flat(mesh, triangle) ? 1 : 0;
    report.shared_points = count_shared_points(mesh);
    const std::vector<MeshEdge> edges = mesh_edges(mesh);
    report.double_triangles = find_double_triangles(mesh, edges).size();
    count_edges(edges, report);
    count_pieces(mesh, edges, report);
}

void add_line(std::vector<std::string>& lines, std::size_t count, const char* one,
              const char* many) {
    if (count > 0) lines.push_back(std::to_string(count) + ' ' + (count == 1 ? one : many));
}

}  // namespace

bool MeshReport::sound() const {
    return lines().empty();
}

std::vector<std::string> MeshReport::lines() const {
    std::vector<std::string> lines;
    add_line(lines, broken_points, "point that is not finite", "points that are not finite");
    add_line(lines, missing_points, "triangle with a point or part that does not exist",
             "triangles with points or parts that do not exist");
    add_line(lines, shared_points, "point of several parts", "points of several parts");
    add_line(lines, flat_triangles, "triangle without area", "triangles without area");
    add_line(lines, double_triangles, "triangle that is there twice",
             "triangles that are there twice");
    add_line(lines, open_edges, "open edge", "open edges");
    add_line(lines, crowded_edges, "edge of more than two triangles",
             "edges of more than two triangles");
    add_line(lines, turned_edges, "edge whose triangles face opposite ways",
             "edges whose triangles face opposite ways");
    add_line(lines, inverted_pieces, "closed piece that is inside out",
             "closed pieces that are inside out");
    return lines;
}

MeshReport validate(const Mesh& mesh) {
    MeshReport report;
    for (const Vec3& point : mesh.points)
        report.broken_points += is_sound(point) ? 0 : 1;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        report.missing_points += has_all(mesh, t) ? 0 : 1;
    if (report.broken_points + report.missing_points == 0) {
        count_sound(mesh, report);
        return report;
    }
    Mesh sound = mesh;
    keep_triangles(sound, [&](std::size_t t) { return is_sound(mesh, t); });
    count_sound(sound, report);
    return report;
}

}  // namespace edaha
