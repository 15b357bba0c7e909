// SPDX-License-Identifier: MIT
#include "energy/joint.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "energy/flank.h"

namespace edaha {
namespace {

// Of the parent's half width: how far from its section a point may be taken for one of it.
constexpr double kNearMiss = 0.05;
// Of the same: how near to its flank a child's counts as crossing it. At a trunk of 10 mm that is
// the last decimal of most pages.
constexpr double kOnFlank = 2e-3;
constexpr int kMostRounds = 5;

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
    Offset centre = offset_at_joint();
    for (double s = stride_; s <= limit_; s += stride_) {
        const LimbSlice child = child_.slice(child_.walk(0, s));
        centre = offset_of(child.centre, centre);
        if (seen_ < steps_.size()) steps_[seen_++] = {s, child, centre};
        if (centre.beyond(1) <= 0 && centre.beyond(-1) <= 0) continue;
        side_ = centre.beyond(1) > 0 ? 1 : -1;
        return;
    }
}

Joint::Offset Joint::offset_at_joint() const {
    return {frame_.centre, 0, 0, frame_.half_width, frame_.tangent};
}

// There the parent is as good as straight.
bool Joint::near_joint(Vec2 point) const {
    return std::abs(glm::dot(point - frame_.centre, frame_.tangent)) < 2 * frame_.half_width;
}

// The way along the parent is known from a point nearby, but for what the parent bends in between.
// If that is much, another step is taken.
Joint::Offset Joint::offset_of(Vec2 point, const Offset& beside) const {
    if (near_joint(point)) {
        const Vec2 away = point - frame_.centre;
        return {point, glm::dot(away, frame_.tangent), cross(frame_.tangent, away),
                frame_.half_width, frame_.tangent};
    }
    double along_mm = beside.along_mm + glm::dot(point - beside.point, beside.tangent);
    for (bool first = true;; first = false) {
        const LimbSlice slice = parent_.slice(parent_.walk(node_, along_mm));
        const Vec2 away = point - slice.centre;
        const double missing_mm = glm::dot(away, slice.tangent);
        along_mm += missing_mm;
        if (first && std::abs(missing_mm) > kNearMiss * slice.half_width) continue;
        return {point, along_mm, cross(slice.tangent, away), slice.half_width, slice.tangent};
    }
}

// Near the joint, too, as the parent bends.
double Joint::parent_distance(const Offset& offset) const {
    if (!near_joint(offset.point)) return offset.along_mm;
    const LimbSlice slice = parent_.slice(parent_.walk(node_, offset.along_mm));
    return offset.along_mm + glm::dot(offset.point - slice.centre, slice.tangent);
}

Joint::Crossing Joint::crossing(int flank, double along_mm, const Offset& beside) const {
    const Vec2 point = child_.slice(child_.walk(0, along_mm)).at(flank);
    return {along_mm, offset_of(point, beside)};
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
std::optional<Joint::Crossing> Joint::way_out(int flank) const {
    std::size_t step = last_inside(flank);
    Crossing inside{0, offset_at_joint()};
    const double first = seen_ > 0 ? steps_[step].along_mm : stride_;
    bool any_inside = false;
    for (double s = first; s <= limit_; s += stride_, ++step) {
        const Crossing here =
            step < seen_ ? Crossing{s, offset_of(steps_[step].child.at(flank), steps_[step].centre)}
                         : crossing(flank, s, inside.corner);
        if (here.corner.beyond(side_) >= 0) return any_inside ? between(flank, inside, here) : here;
        inside = here;
        any_inside = true;
    }
    return std::nullopt;
}

// The Illinois method (Dowell & Jarratt 1971): false position, but an end that stays for two rounds
// counts half.
Joint::Crossing Joint::between(int flank, Crossing inside, Crossing outside) const {
    double depth = inside.corner.beyond(side_), height = outside.corner.beyond(side_);
    int last = 0;
    for (int i = 0; i < kMostRounds; ++i) {
        const double part = depth / (depth - height);
        const double middle = inside.along_mm + (outside.along_mm - inside.along_mm) * part;
        const Crossing here = crossing(flank, middle, inside.corner);
        const double over = here.corner.beyond(side_);
        if (std::abs(over) < kOnFlank * frame_.half_width) return here;
        const int now = over < 0 ? -1 : 1;
        if (now < 0) {
            inside = here, depth = over;
            if (now == last) height /= 2;
        } else {
            outside = here, height = over;
            if (now == last) depth /= 2;
        }
        last = now;
    }
    return outside;
}

std::optional<Fillet> Joint::fillet(int flank, bool ahead) const {
    const auto out = way_out(flank);
    if (!out) return std::nullopt;
    Fillet result;
    result.corner = out->corner.point;
    const double reach = std::min(radius_mm_, (length_mm_ - out->along_mm) * 0.4);
    result.place = child_.walk(0, out->along_mm + reach);
    result.child = child_.section(result.place).sample(flank);
    result.along_mm = parent_distance(out->corner) + (ahead ? reach : -reach);
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
