// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "surface/growing_mesh.h"

namespace edaha {

// The surface of a solid of cubes, two triangles a side: closed where no two cubes meet in an edge
// or corner alone.
template <typename IsSolid>
GrowingMesh block_mesh(const std::array<int, 3>& size, double cube_mm, const Vec3& from,
                       const IsSolid& is_solid) {
    using Place = std::array<int, 3>;
    std::map<Place, std::uint32_t> index;
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    const auto solid = [&](const Place& at) {
        for (std::size_t k = 0; k < 3; ++k)
            if (at[k] < 0 || at[k] >= size[k]) return false;
        return is_solid(at[0], at[1], at[2]);
    };
    const auto point = [&](const Place& at) {
        const auto [found, is_new] =
            index.try_emplace(at, static_cast<std::uint32_t>(points.size()));
        if (is_new) points.push_back(from + cube_mm * Vec3(at[0], at[1], at[2]));
        return found->second;
    };
    const auto side = [&](const Place& at, std::size_t axis, int way) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<std::uint32_t, 4> corners{};
        constexpr std::array<std::array<int, 2>, 4> kRound{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t i = 0; i < 4; ++i) {
            Place corner = at;
            corner[axis] += way > 0 ? 1 : 0;
            corner[u] += kRound[i][0];
            corner[v] += kRound[i][1];
            corners[way > 0 ? i : 3 - i] = point(corner);
        }
        triangles.push_back({corners[0], corners[1], corners[2]});
        triangles.push_back({corners[0], corners[2], corners[3]});
    };
    for (int x = 0; x < size[0]; ++x)
        for (int y = 0; y < size[1]; ++y)
            for (int z = 0; z < size[2]; ++z) {
                const Place at{x, y, z};
                if (!solid(at)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (const int way : {-1, 1}) {
                        Place next = at;
                        next[axis] += way;
                        if (!solid(next)) side(at, axis, way);
                    }
            }
    return growing_mesh(points, triangles);
}

// Two blocks over each other with a gap of `gap` cubes between.
inline GrowingMesh two_blocks(int gap, double cube_mm = 100) {
    return block_mesh({5, 4 + gap, 5}, cube_mm, {0, 1000, 0},
                      [gap](int, int y, int) { return y < 2 || y >= 2 + gap; });
}

inline long euler_number_of(const GrowingMesh& mesh) {
    return static_cast<long>(mesh.vertices()) - static_cast<long>(mesh.faces()) / 2;
}

inline double volume_of(const GrowingMesh& mesh) {
    double sum = 0;
    for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f) {
        if (!mesh.is_face(f)) continue;
        const Vec3 &a = mesh.position[mesh.origin[3 * f]],
                   &b = mesh.position[mesh.origin[3 * f + 1]],
                   &c = mesh.position[mesh.origin[3 * f + 2]];
        sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
               a.z * (b.x * c.y - b.y * c.x);
    }
    return sum / 6;
}

}  // namespace edaha
