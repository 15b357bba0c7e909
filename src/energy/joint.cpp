// SPDX-License-Identifier: MIT
#include "energy/joint.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "energy/flank.h"

namespace edaha {
namespace {

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

Joint::Joint(const LimbCurve& child, const LimbCurve& parent, std::size_t parent_node,
             double radius_mm)
    : child_(child), parent_(parent), node_(parent_node), radius_mm_(radius_mm) {
    const LimbSection at = parent.section_at_node(parent_node);
    frame_ = {at.centre, at.tangent, at.half_width};
    length_mm_ = child.length_mm(0, child.spans());
    limit_ = length_mm_ * 0.66;
    // Half the parent's half width: a child can't slip out and in again between two steps.
    stride_ = std::max(std::min(limit_ / 6, at.half_width / 2), limit_ / 400);
    for (double s = stride_; s <= limit_; s += stride_) {
        const LimbSlice step = child.slice(child.walk(0, s));
        if (seen_ < steps_.size()) steps_[seen_++] = step;
        const Offset offset = offset_of(step.at(0));
        if (offset.beyond(1) <= 0 && offset.beyond(-1) <= 0) continue;
        side_ = offset.beyond(1) > 0 ? 1 : -1;
        return;
    }
}

Vec2 Joint::flank_point(int flank, double s) const {
    return child_.slice(child_.walk(0, s)).at(flank);
}

// Chord length along the parent, from the joint, of the section through a point.
double Joint::parent_distance(Vec2 point) const {
    double s = glm::dot(point - frame_.centre, frame_.tangent);
    const LimbSlice slice = parent_.slice(parent_.walk(node_, s));
    return s + glm::dot(point - slice.centre, slice.tangent);
}

// Near the joint the parent is as good as straight.
Joint::Offset Joint::offset_of(Vec2 point) const {
    const Vec2 away = point - frame_.centre;
    if (std::abs(glm::dot(away, frame_.tangent)) < 2 * frame_.half_width) {
        return {cross(frame_.tangent, away), frame_.half_width};
    }
    const LimbSlice slice = parent_.slice(parent_.walk(node_, parent_distance(point)));
    return {cross(slice.tangent, point - slice.centre), slice.half_width};
}

// Where along the child its flank crosses the parent's: steps, then false position.
std::optional<double> Joint::way_out(int flank) const {
    double inside = 0, depth = 0;
    std::size_t step = 0;
    for (double s = stride_; s <= limit_; s += stride_, ++step) {
        const Vec2 point = step < seen_ ? steps_[step].at(flank) : flank_point(flank, s);
        const double over = offset_of(point).beyond(side_);
        if (over < 0) {
            inside = s, depth = over;
            continue;
        }
        double outside = s, height = over;
        for (int i = 0; i < 3 && depth < 0; ++i) {
            const double middle = inside + (outside - inside) * depth / (depth - height);
            const double at = offset_of(flank_point(flank, middle)).beyond(side_);
            if (at < 0) {
                inside = middle, depth = at;
            } else {
                outside = middle, height = at;
            }
        }
        return outside;
    }
    return std::nullopt;
}

std::optional<Fillet> Joint::fillet(int flank, bool ahead) const {
    const auto out = way_out(flank);
    if (!out) return std::nullopt;
    Fillet result;
    result.corner = flank_point(flank, *out);
    const double reach = std::min(radius_mm_, (length_mm_ - *out) * 0.4);
    result.place = child_.walk(0, *out + reach);
    result.child = child_.section(result.place).sample(flank);
    result.along_mm = parent_distance(result.corner) + (ahead ? reach : -reach);
    const LimbSection base = parent_.section(parent_.walk(node_, result.along_mm));
    // A hair inside the parent, by what its own flank may be off.
    const double inset = 1.5 * flank_tolerance_mm(base.half_width) / base.half_width;
    result.parent = base.sample(side_ * (1 - std::min(inset, 0.2)));
    if (ahead) result.parent.tangent = -result.parent.tangent;
    const bool turns_back =
        glm::length(result.parent.tangent) == 0 || glm::length(result.child.tangent) == 0;
    if (turns_back) return std::nullopt;
    return result;
}

}  // namespace edaha
