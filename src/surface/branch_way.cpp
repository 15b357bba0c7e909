// SPDX-License-Identifier: MIT
#include "surface/branch_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "base/stable_math.h"

namespace edaha {

namespace {

// A step shorter than this has no direction of its own.
constexpr double kShortest_mm = 1e-6;

Vec3 reflected(const Vec3& v, const Vec3& axis) {
    const double square = glm::dot(axis, axis);
    return square > 0 ? v - axis * (2 * glm::dot(v, axis) / square) : v;
}

// Square to the heading, roughly towards z (or x), so that trunks start alike.
Vec3 first_side(const Vec3& heading) {
    const Vec3 hint = std::abs(heading.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    return glm::normalize(hint - heading * glm::dot(hint, heading));
}

}  // namespace

BranchWay::BranchWay(const Apex& apex) {
    for (std::size_t i = 0; i < apex.path.size(); ++i) {
        if (!points_.empty() && glm::distance(points_.back(), apex.path[i]) < kShortest_mm)
            continue;
        points_.push_back(apex.path[i]);
        travels_.push_back(apex.travels[i]);
    }
    if (points_.size() < 2) {
        points_.push_back(points_.back() + apex.state.frame[0]);
        travels_.push_back(travels_.back() + 1);
    }
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        headings_.push_back(glm::normalize(points_[i + 1] - points_[i]));
        if (i == 0) {
            sides_.push_back(first_side(headings_[0]));
            continue;
        }
        const Vec3 chord = points_[i] - points_[i - 1];
        const Vec3 side = reflected(sides_[i - 1], chord);
        const Vec3 heading = reflected(headings_[i - 1], chord);
        const Vec3 turned = reflected(side, headings_[i] - heading);
        sides_.push_back(glm::normalize(turned - headings_[i] * glm::dot(turned, headings_[i])));
    }
}

WayPlace BranchWay::place(const Vec3& point) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity(), best_at = 0;
    for (std::size_t i = 0; i < headings_.size(); ++i) {
        const double length = glm::dot(points_[i + 1] - points_[i], headings_[i]);
        const double low = i == 0 ? -std::numeric_limits<double>::infinity() : 0;
        const double high =
            i + 1 == headings_.size() ? std::numeric_limits<double>::infinity() : length;
        const double at = std::clamp(glm::dot(point - points_[i], headings_[i]), low, high);
        const Vec3 off = point - points_[i] - headings_[i] * at;
        if (glm::dot(off, off) >= least) continue;
        least = glm::dot(off, off);
        best = i;
        best_at = at;
    }
    const Vec3 off = point - points_[best] - headings_[best] * best_at;
    const Vec3 across = glm::cross(headings_[best], sides_[best]);
    return {travels_[best] + best_at,
            stable::atan2(glm::dot(off, across), glm::dot(off, sides_[best])), std::sqrt(least),
            headings_[best]};
}

}  // namespace edaha
