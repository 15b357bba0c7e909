// SPDX-License-Identifier: MIT
#include "surface/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace edaha {
namespace {

constexpr double kGradientStep_mm = 1e-3;
// A zigzag of wire: as wide as eight of its radii, at right angles.
constexpr double kZigzag = 8;

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 way = b - a;
    const double length2 = glm::dot(way, way);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0;
    return glm::distance(p, a + way * t);
}

double to_box(const Vec3& p, const Vec3& low, const Vec3& high) {
    const Vec3 off = glm::max(low - p, p - high);
    const double inside = std::max({off.x, off.y, off.z});
    return inside < 0 ? inside : glm::length(glm::max(off, Vec3(0)));
}

}  // namespace

std::vector<Vec3> wire_corners(const SolidParams& wire) {
    const Vec3 run = wire.to - wire.from;
    const double length = glm::length(run);
    if (length <= 0) return {wire.from};
    Vec3 across = glm::cross(run, Vec3(0, 0, 1));
    if (glm::length(across) < 1e-6 * length) across = Vec3(1, 0, 0);
    across = glm::normalize(across) * (kZigzag / 2 * wire.radius_mm);
    const int turns =
        std::max(1, static_cast<int>(std::lround(length / (kZigzag * wire.radius_mm))));
    std::vector<Vec3> corners;
    for (int i = 0; i <= turns; ++i)
        corners.push_back(wire.from + run * (double(i) / turns) + (i % 2 == 0 ? across : -across));
    return corners;
}

Solid::Solid(const SolidParams& params) : params_(params) {
    if (params.shape == SolidShape::wire) corners_ = wire_corners(params);
    if (params.shape == SolidShape::mesh && params.mesh)
        mesh_ = std::make_shared<const SolidMesh>(*params.mesh);
}

double Solid::distance(const Vec3& p, double enough) const {
    const Vec3 &from = params_.from, &to = params_.to;
    switch (params_.shape) {
        case SolidShape::plane: {
            const double length = glm::distance(from, to);
            return length > 0 ? glm::dot(p - from, to - from) / length : p.y - from.y;
        }
        case SolidShape::box:
            return to_box(p, glm::min(from, to), glm::max(from, to));
        case SolidShape::ball:
            return glm::distance(p, from) - params_.radius_mm;
        case SolidShape::rod:
            return to_segment(p, from, to) - params_.radius_mm;
        case SolidShape::wire: {
            double least = glm::distance(p, corners_[0]);
            for (std::size_t i = 1; i < corners_.size(); ++i)
                least = std::min(least, to_segment(p, corners_[i - 1], corners_[i]));
            return least - params_.radius_mm;
        }
        case SolidShape::mesh:
            return mesh_ ? mesh_->distance(p - from, enough) : enough;
    }
    return std::numeric_limits<double>::infinity();
}

Vec3 Solid::outward(const Vec3& p) const {
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 off(0);
        off[axis] = kGradientStep_mm;
        gradient[axis] = distance(p + off) - distance(p - off);
    }
    const double length = glm::length(gradient);
    return length > 0 ? gradient / length : Vec3(0, 1, 0);
}

double least_distance(std::span<const Solid> solids, std::int64_t step, const Vec3& p,
                      double enough) {
    double least = std::numeric_limits<double>::infinity();
    for (const Solid& solid : solids) {
        if (solid.step() <= step)
            least = std::min(least, solid.distance(p, std::min(least, enough)));
    }
    return least;
}

double deepest(std::span<const Solid> solids, std::int64_t step, const Vec3& a, const Vec3& b,
               const Vec3& c, double spacing) {
    const Vec3 middle = (a + b + c) / 3.0;
    const double reach =
        std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
    const double near = least_distance(solids, step, middle, reach);
    if (near >= reach) return reach - near;
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int n = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
    double least = near;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            const double u = double(i) / n, v = double(j) / n;
            const Vec3 p = a + (b - a) * u + (c - a) * v;
            least = std::min(least, least_distance(solids, step, p, least));
        }
    }
    return -least;
}

}  // namespace edaha
