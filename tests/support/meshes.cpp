// SPDX-License-Identifier: MIT
#include "support/meshes.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

#include "base/keyed_random.h"

namespace edaha::test {
namespace {

std::uint32_t index(int i) {
    return static_cast<std::uint32_t>(i);
}

Mesh one_part(const char* name) {
    Mesh mesh;
    mesh.parts.push_back({name, 0, -1, 0, std::nullopt});
    mesh.materials.push_back({"wood", std::nullopt});
    return mesh;
}

void quad(Mesh& mesh, int a, int b, int c, int d) {
    mesh.triangles.push_back({index(a), index(b), index(c)});
    mesh.triangles.push_back({index(a), index(c), index(d)});
}

Mesh finished(Mesh mesh) {
    mesh.part_of.assign(mesh.triangles.size(), 0);
    return mesh;
}

template <typename Item>
void shuffle(std::vector<Item>& items, const KeyedRandom& random, std::uint32_t purpose) {
    for (std::size_t i = items.size(); i > 1; --i) {
        const auto j = static_cast<std::size_t>(random.uniform(i, purpose) * double(i));
        std::swap(items[i - 1], items[j]);
    }
}

}  // namespace

Mesh box(Vec3 min, Vec3 max) {
    Mesh mesh = one_part("box");
    for (int i = 0; i < 8; ++i)
        mesh.points.push_back(
            {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z});
    quad(mesh, 0, 2, 3, 1), quad(mesh, 4, 5, 7, 6);
    quad(mesh, 0, 1, 5, 4), quad(mesh, 2, 6, 7, 3);
    quad(mesh, 0, 4, 6, 2), quad(mesh, 1, 3, 7, 5);
    return finished(mesh);
}

Mesh sphere(Vec3 centre, double radius, int rings) {
    Mesh mesh = one_part("sphere");
    const int around = 2 * rings;
    for (int i = 1; i < rings; ++i) {
        const double polar = std::numbers::pi * i / rings;
        for (int j = 0; j < around; ++j) {
            const double azimuth = 2 * std::numbers::pi * j / around;
            mesh.points.push_back(centre + radius * Vec3(std::sin(polar) * std::sin(azimuth),
                                                         std::cos(polar),
                                                         std::sin(polar) * std::cos(azimuth)));
        }
    }
    const int top = static_cast<int>(mesh.points.size()), bottom = top + 1;
    mesh.points.push_back(centre + Vec3(0, radius, 0));
    mesh.points.push_back(centre - Vec3(0, radius, 0));
    for (int j = 0; j < around; ++j) {
        const int k = (j + 1) % around, last = (rings - 2) * around;
        mesh.triangles.push_back({index(top), index(j), index(k)});
        for (int i = 0; i + 2 < rings; ++i)
            quad(mesh, i * around + j, (i + 1) * around + j, (i + 1) * around + k, i * around + k);
        mesh.triangles.push_back({index(bottom), index(last + k), index(last + j)});
    }
    return finished(mesh);
}

Mesh torus(double radius, double tube_radius, int around, int across) {
    Mesh mesh = one_part("torus");
    for (int i = 0; i < around; ++i) {
        const double u = 2 * std::numbers::pi * i / around;
        for (int j = 0; j < across; ++j) {
            const double v = 2 * std::numbers::pi * j / across;
            const double r = radius + tube_radius * std::cos(v);
            mesh.points.push_back({r * std::sin(u), tube_radius * std::sin(v), r * std::cos(u)});
        }
    }
    for (int i = 0; i < around; ++i) {
        const int k = (i + 1) % around;
        for (int j = 0; j < across; ++j) {
            const int l = (j + 1) % across;
            quad(mesh, i * across + j, k * across + j, k * across + l, i * across + l);
        }
    }
    return finished(mesh);
}

Mesh prism(Vec3 from, Vec3 to, double radius, int sides) {
    Mesh mesh = one_part("prism");
    const Vec3 d = glm::normalize(to - from);
    const Vec3 u =
        glm::normalize(glm::cross(d, std::abs(d.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
    const Vec3 v = glm::cross(d, u);
    for (const Vec3 end : {from, to}) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            mesh.points.push_back(end + radius * (std::cos(angle) * u + std::sin(angle) * v));
        }
    }
    for (int i = 0; i < sides; ++i) {
        const int k = (i + 1) % sides;
        quad(mesh, i, k, sides + k, sides + i);
        if (i == 0 || k == 0) continue;
        mesh.triangles.push_back({0, index(k), index(i)});
        mesh.triangles.push_back({index(sides), index(sides + i), index(sides + k)});
    }
    return finished(mesh);
}

Mesh sheet(Vec3 corner, Vec3 along, Vec3 across) {
    Mesh mesh = one_part("sheet");
    mesh.points = {corner, corner + along, corner + along + across, corner + across};
    quad(mesh, 0, 1, 2, 3);
    return finished(mesh);
}

void add(Mesh& mesh, const Mesh& more) {
    const auto points = static_cast<std::uint32_t>(mesh.points.size());
    const auto parts = static_cast<std::uint32_t>(mesh.parts.size());
    mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
    for (const Triangle& t : more.triangles)
        mesh.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
    for (const std::uint32_t part : more.part_of)
        mesh.part_of.push_back(part + parts);
    for (MeshPart part : more.parts) {
        part.name += '-' + std::to_string(mesh.parts.size() + 1);
        mesh.parts.push_back(part);
    }
    if (mesh.materials.empty()) mesh.materials = more.materials;
}

Mesh random_prisms(std::uint64_t seed, int count) {
    const KeyedRandom random(0, seed, 1);
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto number = [&](std::uint32_t purpose) {
            return random.uniform(static_cast<Key>(i), purpose) * 10;
        };
        const Vec3 from(number(0), number(1), number(2)), to(number(3), number(4), number(5));
        add(mesh, prism(from, to, 0.1 + 0.05 * number(6), 3 + i % 6));
    }
    return mesh;
}

Mesh shuffled(const Mesh& mesh, std::uint64_t seed) {
    const KeyedRandom random(0, seed, 1);
    std::vector<std::uint32_t> points(mesh.points.size()), triangles(mesh.triangles.size());
    std::iota(points.begin(), points.end(), 0U);
    std::iota(triangles.begin(), triangles.end(), 0U);
    shuffle(points, random, 1);
    shuffle(triangles, random, 2);
    Mesh result = mesh;
    std::vector<std::uint32_t> place(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        result.points[i] = mesh.points[points[i]];
        place[points[i]] = i;
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[triangles[i]];
        const std::uint32_t turn = i % 3;
        for (std::uint32_t k = 0; k < 3; ++k)
            result.triangles[i][k] = place[t[(k + turn) % 3]];
        result.part_of[i] = mesh.part_of[triangles[i]];
    }
    return result;
}

}  // namespace edaha::test
