// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/edges.h"

namespace edaha {

// Triangles that hang together by edges with two triangles. Each piece is known by one of its
// triangles, its root; what is told of pieces is told there.
struct Pieces {
    std::vector<std::uint32_t> root;      // a triangle
    std::vector<std::uint8_t> is_turned;  // a triangle: runs the other way round than its root
    std::vector<std::uint8_t> is_closed;  // a root: every edge has as many ways out as in
    std::vector<double> volume;           // a root: enclosed, if all run as the root does
};

// `edges` are mesh_edges(mesh); indices are in range. Where a piece has but one side (a Moebius
// strip) is_turned fails somewhere. Nearly linear.
Pieces find_pieces(const Mesh& mesh, std::span<const MeshEdge> edges);

// What is told of one pair of points by all its MeshEdges.
struct SideUse {
    std::span<const MeshEdge> edges;
    std::size_t left = 0, right = 0;  // triangles

    std::size_t triangles() const { return left + right; }
    bool is_turned() const { return triangles() == 2 && left != 1; }
};

template <typename Visit>
void for_each_edge_use(std::span<const MeshEdge> edges, const Visit& visit) {
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        SideUse use;
        for (; end < edges.size() && edges[end].a == edges[i].a && edges[end].b == edges[i].b;
             ++end) {
            use.left += edges[end].left != kNone ? 1 : 0;
            use.right += edges[end].right != kNone ? 1 : 0;
        }
        use.edges = edges.subspan(i, end - i);
        visit(use);
    }
}

}  // namespace edaha
