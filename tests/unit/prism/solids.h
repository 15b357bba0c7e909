// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/mesh.h"
#include "prism/prism.h"

// Judges of solids that share nothing with the code that they judge.
namespace edaha::oracles {

// How far two convex hulls are apart, below 0 by how far they reach into each other: the widest gap
// along the normals of all triples of points and the cross products of all pairs of edges, among
// which are those of the hulls' own faces and edges (separating axes). Less where they are apart
// already along x, y or z.
inline double gap(const PrismCorners& a, const PrismCorners& b) {
    double widest = -std::numeric_limits<double>::infinity();
    const auto along = [&](Vec3 axis) {
        const double length = glm::length(axis);
        if (length < 1e-9) return;
        const auto span = [&](const PrismCorners& c) {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const Vec3& p : c) {
                low = std::min(low, glm::dot(p, axis) / length);
                high = std::max(high, glm::dot(p, axis) / length);
            }
            return std::pair(low, high);
        };
        const auto [a_low, a_high] = span(a);
        const auto [b_low, b_high] = span(b);
        widest = std::max({widest, a_low - b_high, b_low - a_high});
    };
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        along(axis);
    if (widest > 0) return widest;
    const auto edges = [](const PrismCorners& c) {
        std::vector<Vec3> all;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < i; ++j)
                all.push_back(c[i] - c[j]);
        return all;
    };
    const auto edges_a = edges(a), edges_b = edges(b);
    for (const auto& own : {edges_a, edges_b})
        for (const Vec3& p : own)
            for (const Vec3& q : own)
                along(glm::cross(p, q));
    for (const Vec3& p : edges_a)
        for (const Vec3& q : edges_b)
            along(glm::cross(p, q));
    return widest;
}

// Of one part: by the divergence theorem; above 0 where triangles look outward.
inline double volume(const Mesh& mesh, std::uint32_t part) {
    double six_times = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.part_of[t] != part) continue;
        const auto& [a, b, c] = mesh.triangles[t];
        six_times += glm::dot(mesh.points[a], glm::cross(mesh.points[b], mesh.points[c]));
    }
    return six_times / 6;
}

// Whether each edge of the mesh is run along once in either direction, by triangles of one part.
inline bool is_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> part_at;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& triangle = mesh.triangles[t];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::pair edge{triangle[i], triangle[(i + 1) % 3]};
            if (!part_at.emplace(edge, mesh.part_of[t]).second) return false;
        }
    }
    return std::ranges::all_of(part_at, [&](const auto& entry) {
        const auto other = part_at.find({entry.first.second, entry.first.first});
        return other != part_at.end() && other->second == entry.second;
    });
}

}  // namespace edaha::oracles
