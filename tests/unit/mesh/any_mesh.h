// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <rapidcheck.h>

#include "shapes.h"

namespace edaha::test {

// One to four boxes of two materials, points being floats, with or without places in (u,v).
inline Mesh any_mesh() {
    Mesh mesh;
    mesh.materials = {{"wood", Colour{1, 2, 255}}, {"leaf green", std::nullopt}};
    const int parts = *rc::gen::inRange(1, 5);
    for (int p = 0; p < parts; ++p) {
        const auto at = [] { return static_cast<float>(*rc::gen::inRange(-999, 999)) / 7; };
        const Vec3 low(at(), at(), at());
        add_box(mesh, "part " + std::to_string(p), low, low + Vec3(0.5, 2, 1));
        MeshPart& part = mesh.parts.back();
        part.material = p < 2 ? static_cast<std::uint32_t>(p) : 1U;
        part.order = static_cast<std::uint32_t>(p);
        part.parent = p - 1;
    }
    if (parts == 1) mesh.materials.pop_back();
    for (Vec3& point : mesh.points)
        point = Vec3(glm::vec3(point));
    if (*rc::gen::arbitrary<bool>()) {
        mesh.uv.resize(mesh.triangles.size(),
                       {glm::dvec2(0, 0.125), glm::dvec2(1, 0), glm::dvec2(0.5, 1)});
    }
    return mesh;
}

// Read back from floats: the same triangles, parts, materials and places.
inline bool same_but_for_rounding(const Mesh& a, const Mesh& b) {
    bool same = a.part_of == b.part_of && a.uv == b.uv && a.parts.size() == b.parts.size() &&
                a.materials.size() == b.materials.size() && a.points.size() == b.points.size();
    for (std::size_t t = 0; same && t < a.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            same = same &&
                   glm::vec3(a.points[a.triangles[t][k]]) == glm::vec3(b.points[b.triangles[t][k]]);
        }
    }
    for (std::size_t p = 0; same && p < a.parts.size(); ++p)
        same = a.parts[p].name == b.parts[p].name && a.parts[p].material == b.parts[p].material;
    for (std::size_t m = 0; same && m < a.materials.size(); ++m) {
        same = a.materials[m].name == b.materials[m].name &&
               a.materials[m].colour == b.materials[m].colour;
    }
    return same;
}

}  // namespace edaha::test
