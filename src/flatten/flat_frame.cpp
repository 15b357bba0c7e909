// SPDX-License-Identifier: MIT
#include "flatten/flat_frame.h"

#include <glm/geometric.hpp>

namespace edaha {
namespace {

// How much larger than in the middle things are seen that are so much farther away.
double nearness(const FlatFrame& frame, Vec3 from_middle) {
    if (!(frame.distance > 0)) return 1;
    return frame.distance / (frame.distance - glm::dot(from_middle, frame.to_eye));
}

Vec2 seen(const FlatFrame& frame, Vec3 point) {
    const Vec3 p = point - frame.middle;
    return Vec2(glm::dot(p, frame.right), -glm::dot(p, frame.up)) *
           (frame.mm_per_unit * nearness(frame, p));
}

}  // namespace

Vec2 FlatFrame::flat_from_world(Vec3 point) const {
    return seen(*this, point) - seen(*this, Vec3(0));
}

double FlatFrame::mm_per_unit_at(Vec3 point) const {
    return mm_per_unit * nearness(*this, point - middle);
}

}  // namespace edaha
