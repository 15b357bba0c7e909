// SPDX-License-Identifier: MIT
#include "surface/channels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "surface/crossings.h"

namespace edaha {
namespace {

// How far the normals round a channel have to look to its middle (mean cosine): in wood that thin
// they look away from it, on a surface that is about flat neither.
constexpr double kInwards = 0.3;

using Cycle = std::array<std::uint32_t, 3>;

// The sum of the normals of the faces round v, by their areas, normalised.
Vec3 normal_at(const GrowingMesh& mesh, std::uint32_t v) {
    Vec3 sum(0);
    mesh.for_each_out(v, [&](std::uint32_t h) {
        const Vec3 &b = mesh.position[mesh.target(h)],
                   &c = mesh.position[mesh.origin[GrowingMesh::previous(h)]];
        sum += glm::cross(b - mesh.position[v], c - mesh.position[v]);
    });
    const double length = glm::length(sum);
    return length > 0 ? sum / length : Vec3(0);
}

// Whether what the three edges run round is air.
bool is_round_air(const GrowingMesh& mesh, const Cycle& vertices) {
    Vec3 middle(0);
    for (const std::uint32_t v : vertices)
        middle += mesh.position[v] / 3.0;
    double sum = 0;
    for (const std::uint32_t v : vertices) {
        const Vec3 way = middle - mesh.position[v];
        const double length = glm::length(way);
        if (length > 0) sum += glm::dot(normal_at(mesh, v), way) / length;
    }
    return sum > 3 * kInwards;
}

bool may_double(const GrowingMesh& mesh, std::uint32_t v) {
    return mesh.is_bud[v] == 0 && mesh.tissue[v] != Tissue::apex;
}

// The shortest way round a channel by the edge of h: its half-edges.
std::optional<Cycle> channel_at(const GrowingMesh& mesh, std::uint32_t h) {
    const std::uint32_t a = mesh.origin[h], b = mesh.target(h);
    if (!may_double(mesh, a) || !may_double(mesh, b)) return std::nullopt;
    std::array<std::uint32_t, 32> from_a{};  // half-edges; vertices with more have no channel
    std::size_t count = 0;
    mesh.for_each_out(a, [&](std::uint32_t g) {
        if (count < from_a.size()) from_a[count] = g;
        ++count;
    });
    if (count > from_a.size()) return std::nullopt;
    const auto to_a = [&](std::uint32_t c) {
        for (std::size_t k = 0; k < count; ++k)
            if (mesh.target(from_a[k]) == c) return mesh.twin[from_a[k]];
        return kNone;
    };
    std::optional<Cycle> best;
    double least = std::numeric_limits<double>::infinity();
    mesh.for_each_out(b, [&](std::uint32_t g) {
        const std::uint32_t c = mesh.target(g);
        if (c == a || g == GrowingMesh::next(h) ||
            mesh.twin[g] == GrowingMesh::previous(mesh.twin[h]))
            return;
        const std::uint32_t i = to_a(c);
        if (i == kNone || !may_double(mesh, c)) return;
        const double round = glm::distance(mesh.position[b], mesh.position[c]) +
                             glm::distance(mesh.position[c], mesh.position[a]);
        if (round >= least || !is_round_air(mesh, {a, b, c})) return;
        least = round;
        best = Cycle{h, g, i};
    });
    return best;
}

// A vertex like v.
std::uint32_t twin_vertex(GrowingMesh& mesh, std::uint32_t v) {
    const std::uint32_t twin = new_vertex(mesh);
    mesh.position[twin] = mesh.position[v];
    mesh.last[twin] = mesh.last[v];
    mesh.tissue[twin] = mesh.tissue[v];
    mesh.branch[twin] = mesh.branch[v];
    mesh.thickening[twin] = mesh.thickening[v];
    mesh.travel[twin] = mesh.travel[v];
    return twin;
}

// Lines of phloem between v and what is now another's neighbour end.
void cut_links(GrowingMesh& mesh, std::uint32_t v, std::uint32_t near) {
    for (auto* links : {&mesh.phloem_up, &mesh.phloem_down}) {
        if ((*links)[v] == near) (*links)[v] = kNone;
        if ((*links)[near] == v) (*links)[near] = kNone;
    }
}

// The faces that hang together with f, if they are no more than `most`.
std::optional<std::vector<std::uint32_t>> small_piece(const GrowingMesh& mesh, std::uint32_t f,
                                                      std::size_t most) {
    std::vector<std::uint32_t> piece{f}, seen{f};
    std::vector<std::uint8_t> is_in(mesh.origin.size() / 3, 0);
    is_in[f] = 1;
    for (std::size_t at = 0; at < piece.size(); ++at) {
        if (piece.size() > most) return std::nullopt;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t near = mesh.twin[3 * piece[at] + k] / 3;
            if (is_in[near] != 0) continue;
            is_in[near] = 1;
            piece.push_back(near);
        }
    }
    return piece;
}

bool is_bubble(const GrowingMesh& mesh, const std::vector<std::uint32_t>& piece) {
    double volume = 0;
    for (const std::uint32_t f : piece) {
        const Vec3 from = mesh.position[mesh.origin[3 * piece.front()]];
        const Vec3 a = mesh.position[mesh.origin[3 * f]] - from,
                   b = mesh.position[mesh.origin[3 * f + 1]] - from,
                   c = mesh.position[mesh.origin[3 * f + 2]] - from;
        volume += glm::dot(a, glm::cross(b, c));
        for (std::uint32_t k = 0; k < 3; ++k)
            if (mesh.is_bud[mesh.origin[3 * f + k]] != 0) return false;
    }
    return volume < 0;
}

void remove_piece(GrowingMesh& mesh, const std::vector<std::uint32_t>& piece) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t f : piece) {
        for (std::uint32_t k = 0; k < 3; ++k)
            vertices.push_back(mesh.origin[3 * f + k]);
    }
    sort_once(vertices);
    for (const std::uint32_t f : piece)
        free_face(mesh, f);
    for (const std::uint32_t v : vertices)
        free_vertex(mesh, v);
}

bool remove_bubble(GrowingMesh& mesh, std::uint32_t f, std::size_t most) {
    const auto piece = small_piece(mesh, f, most);
    if (!piece || !is_bubble(mesh, *piece)) return false;
    remove_piece(mesh, *piece);
    return true;
}

// Whether the lid of a cut there would pass through a face.
bool is_blocked(const GrowingMesh& mesh, const FaceGrid& grid, const Cycle& cycle) {
    const Corners lid{mesh.position[mesh.origin[cycle[0]]], mesh.position[mesh.origin[cycle[1]]],
                      mesh.position[mesh.origin[cycle[2]]]};
    return crosses_any(grid, lid, [&](std::uint32_t f) -> std::optional<Corners> {
        if (!mesh.is_face(f)) return {};
        return corners_of(mesh, f);
    });
}

struct NarrowEdge {
    double length2;
    std::uint32_t h;
};

std::vector<NarrowEdge> narrow_edges(const GrowingMesh& mesh, double most_mm) {
    auto found = gather<NarrowEdge>(mesh.origin.size(), [&](std::size_t i, auto& some) {
        const auto h = static_cast<std::uint32_t>(i);
        if (mesh.origin[h] == kNone || mesh.twin[h] < h) return;
        const Vec3 way = mesh.position[mesh.origin[h]] - mesh.position[mesh.target(h)];
        if (glm::dot(way, way) < most_mm * most_mm && channel_at(mesh, h))
            some.push_back({glm::dot(way, way), h});
    });
    std::sort(found.begin(), found.end(), [](const NarrowEdge& a, const NarrowEdge& b) {
        return std::tie(a.length2, a.h) < std::tie(b.length2, b.h);
    });
    return found;
}

}  // namespace

// At each corner the half-edges that leave it clockwise from the one ahead, not with it, up to the
// one back are those on the right.
std::uint32_t cut_cycle(GrowingMesh& mesh, std::uint32_t h, std::uint32_t g, std::uint32_t i) {
    const Cycle ahead{h, g, i};
    Cycle corners{}, twins{}, right{};
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = mesh.origin[ahead[k]];
        right[k] = mesh.twin[ahead[k]];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = corners[k], last = right[(k + 2) % 3];
        twins[k] = twin_vertex(mesh, v);
        std::uint32_t at = right[k];
        do {
            at = GrowingMesh::next(at);
            mesh.origin[at] = twins[k];
            if (at != last) {
                cut_links(mesh, v, mesh.target(at));
                at = mesh.twin[at];
            }
        } while (at != last);
    }
    const std::uint32_t left_cap = 3 * new_face(mesh, corners[1], corners[0], corners[2]);
    join_twins(mesh, left_cap, ahead[0]);      // b -> a
    join_twins(mesh, left_cap + 1, ahead[2]);  // a -> c
    join_twins(mesh, left_cap + 2, ahead[1]);  // c -> b
    const std::uint32_t right_cap = 3 * new_face(mesh, twins[0], twins[1], twins[2]);
    for (std::uint32_t k = 0; k < 3; ++k)
        join_twins(mesh, right_cap + k, right[k]);
    return twins[0];
}

Channels close_channels(GrowingMesh& mesh, const ChannelParams& params) {
    Channels channels;
    for (const NarrowEdge& edge : narrow_edges(mesh, params.narrow_mm)) {
        if (mesh.origin[edge.h] == kNone) continue;
        const auto cycle = channel_at(mesh, edge.h);
        if (!cycle || (params.grid && is_blocked(mesh, *params.grid, *cycle))) continue;
        const std::uint32_t twin = cut_cycle(mesh, (*cycle)[0], (*cycle)[1], (*cycle)[2]);
        ++channels.cut;
        const std::uint32_t left = mesh.twin[edge.h] / 3, right = mesh.out[twin] / 3;
        for (const std::uint32_t lid : {left, right}) {
            const Corners t = corners_of(mesh, lid);
            if (params.grid) params.grid->put(lid, box_round(t[0], t[1], t[2]));
        }
        if (remove_bubble(mesh, left, params.most_faces)) ++channels.bubbles;
        if (mesh.is_face(right) && remove_bubble(mesh, right, params.most_faces))
            ++channels.bubbles;
    }
    return channels;
}

}  // namespace edaha
