// SPDX-License-Identifier: MIT
#include "mesh/pieces.h"

#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

// Sets of triangles that know for each whether it runs as the first of its set does (disjoint sets
// with parity, joined by number, halved on the way).
class TurnedSets {
  public:
    explicit TurnedSets(std::size_t count) : parent_(count), turned_(count, 0) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    struct Found {
        std::uint32_t root;
        std::uint8_t turned;
    };

    Found find(std::uint32_t t) {
        std::uint8_t turned = 0;
        while (parent_[t] != t) {
            const std::uint32_t up = parent_[t];
            turned_[t] ^= turned_[up];  // 0 for a root
            parent_[t] = parent_[up];
            turned ^= turned_[t];
            t = parent_[t];
        }
        return {t, turned};
    }

    void unite(std::uint32_t a, std::uint32_t b, bool turned) {
        Found x = find(a), y = find(b);
        if (x.root == y.root) return;
        if (x.root > y.root) std::swap(x, y);
        parent_[y.root] = x.root;
        turned_[y.root] = x.turned ^ y.turned ^ static_cast<std::uint8_t>(turned);
    }

  private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> turned_;  // against the parent
};

std::uint32_t some_triangle(const MeshEdge& edge) {
    return edge.left != kNone ? edge.left : edge.right;
}

void unite_neighbours(const SideUse& use, TurnedSets& sets) {
    if (use.triangles() != 2) return;
    if (use.is_turned()) {
        sets.unite(some_triangle(use.edges[0]), some_triangle(use.edges[1]), true);
    } else {
        sets.unite(use.edges[0].left, use.edges[0].right, false);
    }
}

// Of the tetrahedron below the triangle, seen from `from`.
double volume_below(const Mesh& mesh, const Triangle& t, const Vec3& from) {
    const Vec3 a = mesh.points[t[0]] - from, b = mesh.points[t[1]] - from;
    return glm::dot(a, glm::cross(b, mesh.points[t[2]] - from)) / 6;
}

}  // namespace

Pieces find_pieces(const Mesh& mesh, std::span<const MeshEdge> edges) {
    const std::size_t count = mesh.triangles.size();
    TurnedSets sets(count);
    for_each_edge_use(edges, [&](const SideUse& use) { unite_neighbours(use, sets); });
    Pieces pieces;
    pieces.root.resize(count);
    pieces.is_turned.resize(count);
    pieces.is_closed.assign(count, 1);
    pieces.volume.assign(count, 0);
    for (std::uint32_t t = 0; t < count; ++t) {
        const auto [root, turned] = sets.find(t);
        pieces.root[t] = root;
        pieces.is_turned[t] = turned;
        const Vec3& from = mesh.points[mesh.triangles[root][0]];
        const double volume = volume_below(mesh, mesh.triangles[t], from);
        pieces.volume[root] += turned != 0 ? -volume : volume;
    }
    for_each_edge_use(edges, [&](const SideUse& use) {
        if (use.triangles() % 2 == 0 && (use.triangles() == 2 || use.left == use.right)) return;
        for (const MeshEdge& edge : use.edges) {
            for (const std::uint32_t t : {edge.left, edge.right}) {
                if (t != kNone) pieces.is_closed[pieces.root[t]] = 0;
            }
        }
    });
    return pieces;
}

}  // namespace edaha
