// SPDX-License-Identifier: MIT
#include "surface/move.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 2000;
constexpr int kRounds = 4;
constexpr double kLeastTurn = 0.17;  // cosine of 80 degrees
constexpr double kLeastArea = 0.1;

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
    return glm::cross(b - a, c - a);
}

Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : Vec3(0);
}

bool on_ground(const Vec3& p) {
    return p.y <= kGround_mm;
}

// Whether a face would turn too far or lose too much of its area.
bool folds(const GrowingMesh& mesh, std::span<const Vec3> of_faces, std::span<const Vec3> moves,
           std::uint32_t f) {
    if (of_faces[f] == Vec3(0)) return false;
    const std::uint32_t a = mesh.origin[3 * f], b = mesh.origin[3 * f + 1],
                        c = mesh.origin[3 * f + 2];
    const Vec3 &p = mesh.position[a], &q = mesh.position[b], &r = mesh.position[c];
    const Vec3 after = area_vector(p + moves[a], q + moves[b], r + moves[c]);
    const double risen = glm::dot(after, of_faces[f]);
    const double before = glm::dot(area_vector(p, q, r), of_faces[f]);
    return risen < kLeastArea * before || risen < kLeastTurn * glm::length(after);
}

}  // namespace

std::vector<Vec3> face_normals(const GrowingMesh& mesh) {
    std::vector<Vec3> normals(mesh.origin.size() / 3, Vec3(0));
    for_each_index(normals.size(), kWorthThreads, [&](std::size_t f) {
        if (mesh.origin[3 * f] == kNone) return;
        normals[f] = unit(area_vector(mesh.position[mesh.origin[3 * f]],
                                      mesh.position[mesh.origin[3 * f + 1]],
                                      mesh.position[mesh.origin[3 * f + 2]]));
    });
    return normals;
}

std::vector<Vec3> vertex_normals(const GrowingMesh& mesh, std::span<const Vec3> of_faces) {
    std::vector<Vec3> normals(mesh.position.size(), Vec3(0));
    for_each_index(normals.size(), kWorthThreads, [&](std::size_t i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (!mesh.is_vertex(v)) return;
        const bool foot = on_ground(mesh.position[v]);
        Vec3 sum(0);
        mesh.for_each_out(v, [&](std::uint32_t h) {
            const Vec3& normal = of_faces[h / 3];
            if (foot && on_ground(mesh.position[mesh.target(h)]) &&
                on_ground(mesh.position[mesh.origin[GrowingMesh::previous(h)]]))
                return;
            sum += normal;
        });
        if (foot) sum.y = 0;
        normals[v] = unit(sum);
    });
    return normals;
}

void stay_on_ground(const GrowingMesh& mesh, std::vector<Vec3>& moves) {
    for_each_index(moves.size(), kWorthThreads, [&](std::size_t v) {
        if (on_ground(mesh.position[v])) moves[v].y = 0;
        moves[v].y = std::max(moves[v].y, -mesh.position[v].y);
    });
}

void limit_moves(const GrowingMesh& mesh, std::span<const Vec3> of_faces,
                 std::vector<Vec3>& moves) {
    stay_on_ground(mesh, moves);
    std::vector<std::uint32_t> folded =
        gather<std::uint32_t>(mesh.origin.size() / 3, [&](std::size_t i, auto& found) {
            const auto f = static_cast<std::uint32_t>(i);
            if (mesh.is_face(f) && folds(mesh, of_faces, moves, f)) found.push_back(f);
        });
    for (int round = 0; round < kRounds && !folded.empty(); ++round) {
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t f : folded)
            vertices.insert(vertices.end(),
                            {mesh.origin[3 * f], mesh.origin[3 * f + 1], mesh.origin[3 * f + 2]});
        sort_once(vertices);
        for (const std::uint32_t v : vertices)
            moves[v] *= round + 1 < kRounds ? 0.5 : 0.0;
        folded = faces_round(mesh, vertices);  // all others are as they were
        std::erase_if(folded, [&](std::uint32_t f) { return !folds(mesh, of_faces, moves, f); });
    }
}

std::vector<Vec3> slides(const GrowingMesh& mesh, std::span<const Vec3> normals, double share) {
    std::vector<Vec3> moves(mesh.position.size(), Vec3(0));
    if (share <= 0) return moves;
    for_each_index(moves.size(), kWorthThreads, [&](std::size_t i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (!mesh.is_vertex(v) || mesh.tissue[v] != Tissue::cambium || mesh.is_bud[v] != 0 ||
            on_ground(mesh.position[v]))
            return;
        Vec3 sum(0);
        int count = 0;
        bool stays = mesh.phloem_up[v] != kNone || mesh.phloem_down[v] != kNone;
        if (stays) return;
        mesh.for_each_out(v, [&](std::uint32_t h) {
            const std::uint32_t other = mesh.target(h);
            stays = stays || mesh.tissue[other] == Tissue::apex;
            sum += mesh.position[other];
            ++count;
        });
        if (stays) return;
        const Vec3 way = sum / static_cast<double>(count) - mesh.position[v];
        moves[v] = share * (way - normals[v] * glm::dot(way, normals[v]));
    });
    return moves;
}

}  // namespace edaha
