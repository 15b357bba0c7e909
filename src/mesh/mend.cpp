// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "mesh/mesh_check.h"
#include "mesh/pieces.h"
#include "mesh/sound_triangles.h"
#include "mesh/weld.h"

namespace edaha {
namespace {

bool has_point_twice(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

void drop_doubles(Mesh& mesh) {
    const std::vector<std::uint32_t> doubles = find_double_triangles(mesh, mesh_edges(mesh));
    if (doubles.empty()) return;
    keep_triangles(mesh, [&](std::size_t t) {
        return !std::binary_search(doubles.begin(), doubles.end(), t);
    });
}

// The first part that has a point keeps it, each other one gets its own.
void split_shared_points(Mesh& mesh) {
    std::vector<std::uint32_t> owner(mesh.points.size(), kNone);
    struct Share {
        std::uint32_t point, part, triangle, corner;
        auto operator<=>(const Share&) const = default;
    };
    std::vector<Share> shares;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t point = mesh.triangles[t][k];
            if (owner[point] == kNone) owner[point] = mesh.part_of[t];
            if (owner[point] != mesh.part_of[t]) shares.push_back({point, mesh.part_of[t], t, k});
        }
    }
    std::sort(shares.begin(), shares.end());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Share& share = shares[i];
        const bool is_first =
            i == 0 || shares[i - 1].point != share.point || shares[i - 1].part != share.part;
        if (is_first) mesh.points.push_back(Vec3(mesh.points[share.point]));
        mesh.triangles[share.triangle][share.corner] =
            static_cast<std::uint32_t>(mesh.points.size() - 1);
    }
}

// Which roots' pieces must turn as a whole: closed ones with a negative volume, of others those
// where the root runs as fewer do.
std::vector<std::uint8_t> pieces_to_turn(const Pieces& pieces) {
    std::vector<std::uint32_t> total(pieces.root.size(), 0), turned(pieces.root.size(), 0);
    for (std::size_t t = 0; t < pieces.root.size(); ++t) {
        ++total[pieces.root[t]];
        turned[pieces.root[t]] += pieces.is_turned[t];
    }
    std::vector<std::uint8_t> turn(pieces.root.size(), 0);
    for (std::size_t t = 0; t < turn.size(); ++t) {
        const bool by_volume = pieces.is_closed[t] != 0 && pieces.volume[t] != 0;
        turn[t] = by_volume ? pieces.volume[t] < 0 : turned[t] > total[t] - turned[t];
    }
    return turn;
}

// Whether anything was turned.
bool orient(Mesh& mesh) {
    const Pieces pieces = find_pieces(mesh, mesh_edges(mesh));
    const std::vector<std::uint8_t> turn = pieces_to_turn(pieces);
    bool changed = false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if ((pieces.is_turned[t] ^ turn[pieces.root[t]]) == 0) continue;
        changed = true;
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        if (!mesh.uv.empty()) std::swap(mesh.uv[t][1], mesh.uv[t][2]);
    }
    return changed;
}

}  // namespace

Mesh mend(Mesh mesh) {
    keep_triangles(mesh, [&](std::size_t t) {
        return is_sound(mesh, t) && !has_point_twice(mesh.triangles[t]);
    });
    drop_doubles(mesh);
    split_shared_points(mesh);
    // Where pieces touch, whether they are closed shows only once all run the same way.
    if (orient(mesh)) orient(mesh);
    drop_unused_points(mesh);
    return mesh;
}

}  // namespace edaha
