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

using Corners = std::array<Vec3, 3>;

// Depth changes by no more than one goes: from the depth in the middle of a triangle follows how
// deep it can be at most. Where that is too much to be left, both halves are looked at.
class DepthSearch {
  public:
    DepthSearch(std::span<const Solid> solids, const DepthParams& params)
        : solids_(solids), params_(params) {}

    // The depth, or the most so far.
    double look(const Corners& corners, double most) const {
        const Outlook at = look_round(corners, most);
        if (at.is_settled) return std::max(most, at.depth);
        const auto halves = halves_of(corners);
        return look(halves[1], look(halves[0], std::max(most, at.depth)));
    }

    // Whether the depth is more than the least. Stops at the first place that shows it.
    bool is_more(const Corners& corners) const {
        const Outlook at = look_round(corners, params_.least);
        if (at.depth > params_.least) return true;
        if (at.is_settled) return false;
        const auto halves = halves_of(corners);
        return is_more(halves[0]) || is_more(halves[1]);
    }

  private:
    static double squared(const Vec3& v) { return glm::dot(v, v); }

    struct Outlook {
        double depth;     // in the middle
        bool is_settled;  // nothing is deeper than that, or than the most, by the tolerance
    };

    Outlook look_round(const Corners& corners, double most) const {
        const auto& [a, b, c] = corners;
        const Vec3 middle = (a + b + c) / 3.0;
        const double reach =
            std::sqrt(std::max({squared(a - middle), squared(b - middle), squared(c - middle)}));
        const double enough = reach - most - params_.tolerance_mm;
        const double distance = least_distance(solids_, params_.step, middle, enough);
        return {-distance, distance >= enough || reach <= params_.tolerance_mm};
    }

    // Of the longest edge.
    static std::array<Corners, 2> halves_of(const Corners& corners) {
        const auto& [a, b, c] = corners;
        const double ab = squared(b - a), bc = squared(c - b), ca = squared(a - c);
        if (ab >= bc && ab >= ca) return halves_at(a, b, c);
        return bc >= ca ? halves_at(b, c, a) : halves_at(c, a, b);
    }
    static std::array<Corners, 2> halves_at(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 between = (a + b) / 2.0;
        return {Corners{a, between, c}, Corners{between, b, c}};
    }

    std::span<const Solid> solids_;
    const DepthParams& params_;
};

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

double deepest(std::span<const Solid> solids, const std::array<Vec3, 3>& corners,
               const DepthParams& params) {
    return DepthSearch(solids, params).look(corners, params.least);
}

bool is_deeper(std::span<const Solid> solids, const std::array<Vec3, 3>& corners,
               const DepthParams& params) {
    return DepthSearch(solids, params).is_more(corners);
}

}  // namespace edaha
