// SPDX-License-Identifier: MIT
#include "proproot/root_space.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

// In sums of the radii. Less leaves no room for two roots to part at a small angle; more lets them
// pass through each other visibly.
constexpr double kJoint = 2.5;

// Whether two stretches come closer than their radii, which change evenly, add up to.
bool touch(const LinePoint& a0, const LinePoint& a1, const LinePoint& b0, const LinePoint& b1) {
    // Closest points of two segments, at s and t of them (Ericson 2005, 5.1.9).
    const Vec3 d1 = a1.position - a0.position, d2 = b1.position - b0.position;
    const Vec3 r = a0.position - b0.position;
    const double a = glm::dot(d1, d1), e = glm::dot(d2, d2), f = glm::dot(d2, r);
    const double c = glm::dot(d1, r), b = glm::dot(d1, d2);
    const double denominator = a * e - b * b;
    double s =
        denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0;
    double t = (b * s + f) / e;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((b * t - c) / a, 0.0, 1.0);
    }
    const double radii =
        a0.radius + (a1.radius - a0.radius) * s + b0.radius + (b1.radius - b0.radius) * t;
    const Vec3 apart = r + d1 * s - d2 * t;
    return glm::dot(apart, apart) < radii * radii;
}

}  // namespace

double joint_length(double radius, double parent_radius) {
    return kJoint * (radius + parent_radius);
}

namespace {

// The part of a stretch that lies beyond its line's joint.
std::optional<LinePoint> start_beyond(const LinePoint& from, const LinePoint& to, double joint) {
    if (to.along <= joint) return std::nullopt;
    if (from.along >= joint) return from;
    const double t = (joint - from.along) / (to.along - from.along);
    return LinePoint{from.position + (to.position - from.position) * t, joint,
                     from.radius + (to.radius - from.radius) * t};
}

}  // namespace

template <typename Visit>
bool RootSpace::any_cell(const Stretch& stretch, const Visit& visit) const {
    const double margin = std::max(stretch.from.radius, stretch.to.radius);
    const Vec3 &a = stretch.from.position, &b = stretch.to.position;
    const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    for (std::int64_t i = cell(std::min(a.x, b.x) - margin); i <= cell(std::max(a.x, b.x) + margin);
         ++i) {
        for (std::int64_t j = cell(std::min(a.z, b.z) - margin);
             j <= cell(std::max(a.z, b.z) + margin); ++j) {
            const auto key = static_cast<Cell>(i) << 32 | (static_cast<Cell>(j) & 0xffffffffU);
            if (visit(key)) return true;
        }
    }
    return false;
}

bool RootSpace::free(std::span<const LinePoint> line, const RootBody& body) const {
    const auto hits = [&](const Stretch& own, const Stretch& other) {
        const auto whole = [&] { return touch(own.from, own.to, other.from, other.to); };
        const auto own_beyond = [&] {
            const auto start = start_beyond(own.from, own.to, body.joint);
            return start && touch(*start, own.to, other.from, other.to);
        };
        const auto other_beyond = [&] {
            const auto start = start_beyond(other.from, other.to, other.body.joint);
            return start && touch(own.from, own.to, *start, other.to);
        };
        if (other.body.self == body.parent) return own_beyond();
        if (other.body.parent == body.self) return other_beyond();
        if (other.body.parent == body.parent) return own_beyond() || other_beyond();
        return whole();
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Stretch own{line[i], line[i + 1], body};
        const bool hit = any_cell(own, [&](Cell cell) {
            const auto column = columns_.find(cell);
            if (column == columns_.end()) return false;
            return std::any_of(column->second.begin(), column->second.end(),
                               [&](std::uint32_t j) { return hits(own, stretches_[j]); });
        });
        if (hit) return false;
    }
    return true;
}

void RootSpace::add(std::span<const LinePoint> line, const RootBody& body) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto index = static_cast<std::uint32_t>(stretches_.size());
        stretches_.push_back({line[i], line[i + 1], body});
        any_cell(stretches_.back(), [&](Cell cell) {
            columns_[cell].push_back(index);
            return false;
        });
    }
}

}  // namespace edaha
