// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "mesh/mesh.h"

namespace edaha::test {

inline void add_part(Mesh& mesh, const std::string& name) {
    if (mesh.materials.empty()) mesh.materials.push_back({"wood", {}});
    MeshPart part;
    part.name = name;
    mesh.parts.push_back(std::move(part));
}

inline void add_triangle(Mesh& mesh, const Triangle& triangle) {
    mesh.triangles.push_back(triangle);
    mesh.part_of.push_back(static_cast<std::uint32_t>(mesh.parts.size() - 1));
}

// A box as a part: eight points, twelve triangles.
inline void add_box(Mesh& mesh, const std::string& name, const Vec3& low, const Vec3& high) {
    add_part(mesh, name);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (unsigned corner = 0; corner < 8; ++corner) {
        mesh.points.emplace_back((corner & 1) != 0 ? high.x : low.x,
                                 (corner & 2) != 0 ? high.y : low.y,
                                 (corner & 4) != 0 ? high.z : low.z);
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& side : kSides) {
        add_triangle(mesh, {first + side[0], first + side[1], first + side[2]});
        add_triangle(mesh, {first + side[0], first + side[2], first + side[3]});
    }
}

inline Mesh box(const Vec3& low = Vec3(0), const Vec3& high = Vec3(1)) {
    Mesh mesh;
    add_box(mesh, "box", low, high);
    return mesh;
}

// A closed torus round the y axis.
inline Mesh torus(std::uint32_t around, std::uint32_t across) {
    Mesh mesh;
    add_part(mesh, "torus");
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = 2 * std::numbers::pi * k / across;
            const double r = 3 + std::cos(v);
            mesh.points.emplace_back(r * std::cos(u), std::sin(v), r * std::sin(u));
            const std::uint32_t i2 = (i + 1) % around, k2 = (k + 1) % across;
            const std::uint32_t a = i * across + k, b = i * across + k2, c = i2 * across + k2,
                                d = i2 * across + k;
            add_triangle(mesh, {a, b, c});
            add_triangle(mesh, {a, c, d});
        }
    }
    return mesh;
}

// Six times the enclosed volume.
inline double volume6(const Mesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
               a.z * (b.x * c.y - b.y * c.x);
    }
    return sum;
}

}  // namespace edaha::test
