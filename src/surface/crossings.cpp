// SPDX-License-Identifier: MIT
#include "surface/crossings.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

// Volumes below this share of the cube of the size are rounding, or touching.
constexpr double kTouching = 1e-9;

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    return glm::dot(p - a, glm::cross(b - a, c - a));
}

// Of each corner of s against the plane of t.
std::array<double, 3> sides(const Corners& s, const Corners& t) {
    const Vec3 square = glm::cross(t[1] - t[0], t[2] - t[0]);
    return {glm::dot(s[0] - t[0], square), glm::dot(s[1] - t[0], square),
            glm::dot(s[2] - t[0], square)};
}

bool on_one_side(const std::array<double, 3>& side, double least) {
    const auto [low, high] = std::minmax({side[0], side[1], side[2]});
    return low >= -least || high <= least;
}

// Whether an edge of s goes through t; `side` is where the corners of s lie.
bool pierces(const Corners& s, const Corners& t, const std::array<double, 3>& side, double least) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (std::abs(side[i]) <= least || std::abs(side[j]) <= least ||
            (side[i] > 0) == (side[j] > 0))
            continue;
        const double ab = volume(s[i], s[j], t[0], t[1]), bc = volume(s[i], s[j], t[1], t[2]),
                     ca = volume(s[i], s[j], t[2], t[0]);
        if ((ab > least && bc > least && ca > least) || (ab < -least && bc < -least && ca < -least))
            return true;
    }
    return false;
}

double size_of(const Corners& s, const Corners& t) {
    const Vec3 low = glm::min(glm::min(glm::min(s[0], s[1]), s[2]),
                              glm::min(glm::min(t[0], t[1]), t[2])),
               high = glm::max(glm::max(glm::max(s[0], s[1]), s[2]),
                               glm::max(glm::max(t[0], t[1]), t[2]));
    const Vec3 extent = high - low;
    return std::max({extent.x, extent.y, extent.z});
}

// Of the boxes of all faces, on average.
double mean_extent(const GrowingMesh& mesh) {
    double sum = 0;
    std::size_t count = 0;
    for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f) {
        if (!mesh.is_face(f)) continue;
        const Corners t = corners_of(mesh, f);
        sum += size_of(t, t);
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

// Most pairs are told apart by one plane without its tolerance, which takes as long again.
bool triangles_cross(const Corners& s, const Corners& t) {
    const std::array<double, 3> of_s = sides(s, t);
    if (on_one_side(of_s, 0)) return false;
    const std::array<double, 3> of_t = sides(t, s);
    if (on_one_side(of_t, 0)) return false;
    const double size = size_of(s, t), least = kTouching * size * size * size;
    if (on_one_side(of_s, least) || on_one_side(of_t, least)) return false;
    return pierces(s, t, of_s, least) || pierces(t, s, of_t, least);
}

// By the region of the plane that p lies in: beside which corner or edge, or over the inside.
Vec3 nearest_point(const Corners& triangle, const Vec3& p) {
    const auto& [a, b, c] = triangle;
    const Vec3 square = glm::cross(b - a, c - a);
    const double area = glm::dot(square, square);
    const auto inside = [&](const Vec3& from, const Vec3& to) {
        return glm::dot(glm::cross(to - from, p - from), square) >= 0;
    };
    if (area > 0 && inside(a, b) && inside(b, c) && inside(c, a))
        return p - square * (glm::dot(p - a, square) / area);
    Vec3 best = a;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = triangle[i], along = triangle[(i + 1) % 3] - from;
        const double length2 = glm::dot(along, along);
        const double t = length2 > 0 ? glm::dot(p - from, along) / length2 : 0;
        const Vec3 near = from + along * std::clamp(t, 0.0, 1.0);
        if (glm::dot(near - p, near - p) < glm::dot(best - p, best - p)) best = near;
    }
    return best;
}

Corners corners_of(const GrowingMesh& mesh, std::uint32_t f) {
    return {mesh.position[mesh.origin[3 * f]], mesh.position[mesh.origin[3 * f + 1]],
            mesh.position[mesh.origin[3 * f + 2]]};
}

std::vector<std::array<std::uint32_t, 2>> crossing_faces(const GrowingMesh& mesh) {
    using Pair = std::array<std::uint32_t, 2>;
    const double extent = mean_extent(mesh);
    if (extent == 0) return {};
    const FaceGrid grid(mesh, extent);
    std::vector<Pair> found =
        gather<Pair>(grid.buckets(), [&](std::size_t bucket, std::vector<Pair>& pairs) {
            grid.visit_pairs(bucket, [&](std::uint32_t f, std::uint32_t g) {
                if (triangles_cross(corners_of(mesh, f), corners_of(mesh, g)))
                    pairs.push_back({std::min(f, g), std::max(f, g)});
            });
        });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace edaha
