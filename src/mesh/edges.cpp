// SPDX-License-Identifier: MIT
#include "mesh/edges.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

namespace edaha {
namespace {

// One side of a triangle as a number: the larger point, the triangle, and whether it runs from the
// larger point to the smaller.
using Side = std::uint64_t;

constexpr std::uint32_t kFewSides = 24;  // sorted by insertion, which is the quicker one up to here

Side make_side(std::uint32_t larger, std::size_t triangle, bool down) {
    return std::uint64_t{larger} << 32 | triangle << 1 | std::uint64_t{down};
}

std::uint32_t larger_point(Side side) {
    return static_cast<std::uint32_t>(side >> 32);
}

std::uint32_t triangle_of(Side side) {
    return static_cast<std::uint32_t>(side) >> 1;
}

bool runs_down(Side side) {
    return (side & 1) != 0;
}

// Sides by their smaller point: those of point p are sides[first[p]] to sides[first[p + 1]].
struct SidesByPoint {
    std::vector<std::uint32_t> first;
    std::vector<Side> sides;
};

template <typename Visit>
void for_each_side(const std::vector<Triangle>& triangles, const Visit& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& corners = triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k], to = corners[k == 2 ? 0 : k + 1];
            if (from != to) visit(t, from, to);
        }
    }
}

SidesByPoint collect(const Mesh& mesh) {
    SidesByPoint result;
    std::vector<std::uint32_t>& first = result.first;
    first.assign(mesh.points.size() + 2, 0);
    for_each_side(mesh.triangles, [&](std::size_t, std::uint32_t from, std::uint32_t to) {
        ++first[std::min(from, to) + 2];
    });
    for (std::size_t i = 2; i < first.size(); ++i)
        first[i] += first[i - 1];
    result.sides.resize(first.back());
    // first[p + 1] moves from the beginning of p's sides to their end.
    for_each_side(mesh.triangles, [&](std::size_t t, std::uint32_t from, std::uint32_t to) {
        const auto [smaller, larger] = std::minmax(from, to);
        result.sides[first[smaller + 1]++] = make_side(larger, t, from == larger);
    });
    return result;
}

void sort_sides(std::span<Side> sides) {
    if (sides.size() > kFewSides) {
        std::sort(sides.begin(), sides.end());
        return;
    }
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side side = sides[i];
        std::size_t k = i;
        for (; k > 0 && sides[k - 1] > side; --k)
            sides[k] = sides[k - 1];
        sides[k] = side;
    }
}

// The sides of one pair of points, by triangle: the n-th of one direction goes with the n-th of the
// other.
void pair_sides(std::uint32_t a, std::span<const Side> sides, std::vector<MeshEdge>& edges) {
    const std::size_t begin = edges.size();
    std::size_t counts[2] = {};
    for (const Side side : sides) {
        const bool down = runs_down(side);
        const std::size_t at = begin + counts[down]++;
        if (at == edges.size()) edges.push_back({a, larger_point(side)});
        (down ? edges[at].right : edges[at].left) = triangle_of(side);
    }
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const Mesh& mesh) {
    assert(mesh.triangles.size() < (std::size_t{1} << 31));
    SidesByPoint by_point = collect(mesh);
    std::vector<MeshEdge> edges;
    edges.reserve(by_point.sides.size() / 2 + 64);
    for (std::uint32_t a = 0; a < mesh.points.size(); ++a) {
        const std::span<Side> sides(by_point.sides.data() + by_point.first[a],
                                    by_point.first[a + 1] - by_point.first[a]);
        sort_sides(sides);
        for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
            while (end < sides.size() && larger_point(sides[end]) == larger_point(sides[i]))
                ++end;
            pair_sides(a, sides.subspan(i, end - i), edges);
        }
    }
    return edges;
}

}  // namespace edaha
