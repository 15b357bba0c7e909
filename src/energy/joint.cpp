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
    : child_(child),
      parent_(parent),
      node_(parent_node),
      radius_mm_(radius_mm),
      frame_(parent.slice_at_node(parent_node)),
      length_mm_(child.length_mm(0, child.spans())),
      limit_(length_mm_ * 0.66),
      // Half the parent's half width: a child can't slip out and in again between two steps.
      stride_(std::max(std::min(limit_ / 6, frame_.half_width / 2), limit_ / 400)) {
    find_side();
}

void Joint::find_side() {
    for (double s = stride_; s <= limit_; s += stride_) {
        const LimbSlice child = child_.slice(child_.walk(0, s));
        const Offset centre = offset_of(child.centre);
        if (seen_ < steps_.size()) steps_[seen_++] = {s, child, centre};
        if (centre.beyond(1) <= 0 && centre.beyond(-1) <= 0) continue;
        side_ = centre.beyond(1) > 0 ? 1 : -1;
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

// There the parent is as good as straight.
bool Joint::near_joint(Vec2 point) const {
    return std::abs(glm::dot(point - frame_.centre, frame_.tangent)) < 2 * frame_.half_width;
}

Joint::Offset Joint::offset_of(Vec2 point) const {
    if (near_joint(point)) {
        return {cross(frame_.tangent, point - frame_.centre), frame_.half_width, frame_.tangent};
    }
    const LimbSlice slice = parent_.slice(parent_.walk(node_, parent_distance(point)));
    return {cross(slice.tangent, point - slice.centre), slice.half_width, slice.tangent};
}

// By the parent's section through the child's centre, as if the parent were straight over the
// child's width. A quarter of the half width makes up for what it bends.
bool Joint::surely_inside(const Step& step, int flank) const {
    const double half_width = step.child.half_width;
    const double aside = flank * half_width * glm::dot(step.child.tangent, step.centre.tangent);
    return step.centre.beyond(side_) + side_ * aside < -0.25 * half_width;
}

// The last of the first strides up to which a flank is surely inside.
std::size_t Joint::last_inside(int flank) const {
    std::size_t step = 0;
    while (step < seen_ && surely_inside(steps_[step], flank))
        ++step;
    while (step > 0 && near_joint(steps_[step - 1].child.at(flank)) !=
                           near_joint(steps_[step - 1].child.centre))
        --step;
    return step > 0 ? step - 1 : 0;
}

// Where along the child its flank crosses the parent's: steps, then false position.
std::optional<Joint::WayOut> Joint::way_out(int flank) const {
    double inside = 0, depth = 0;
    std::size_t step = last_inside(flank);
    const double first = seen_ > 0 ? steps_[step].along_mm : stride_;
    for (double s = first; s <= limit_; s += stride_, ++step) {
        Vec2 corner = step < seen_ ? steps_[step].child.at(flank) : flank_point(flank, s);
        const double over = offset_of(corner).beyond(side_);
        if (over < 0) {
            inside = s, depth = over;
            continue;
        }
        double outside = s, height = over;
        for (int i = 0; i < 3 && depth < 0; ++i) {
            const double middle = inside + (outside - inside) * depth / (depth - height);
            const Vec2 point = flank_point(flank, middle);
            const double at = offset_of(point).beyond(side_);
            if (at < 0) {
                inside = middle, depth = at;
            } else {
                outside = middle, height = at, corner = point;
            }
        }
        return WayOut{outside, corner};
    }
    return std::nullopt;
}

std::optional<Fillet> Joint::fillet(int flank, bool ahead) const {
    const auto out = way_out(flank);
    if (!out) return std::nullopt;
    Fillet result;
    result.corner = out->corner;
    const double reach = std::min(radius_mm_, (length_mm_ - out->along_mm) * 0.4);
    result.place = child_.walk(0, out->along_mm + reach);
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
