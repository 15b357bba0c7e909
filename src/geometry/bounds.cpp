// SPDX-License-Identifier: MIT
#include "geometry/bounds.h"

#include <cmath>

#include "geometry/bezier.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

// Includes the points where one coordinate of the cubic turns: roots of a t^2 + b t + c inside
// (0, 1), the derivative's Bernstein coefficients d0, d1, d2 written as powers.
void include_turns(Bounds& box, const Cubic& curve, int axis) {
    const double d0 = curve.p1[axis] - curve.p0[axis];
    const double d1 = curve.p2[axis] - curve.p1[axis];
    const double d2 = curve.p3[axis] - curve.p2[axis];
    const double a = d0 - 2 * d1 + d2;
    const double b = 2 * (d1 - d0);
    const double discriminant = b * b - 4 * a * d0;
    if (discriminant < 0) return;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    for (const double t : {q / a, d0 / q}) {
        if (t > 0 && t < 1) box.include(eval(curve, t));  // NaN and infinity fail the test
    }
}

}  // namespace

void Bounds::include(const Bounds& other) {
    if (other.empty()) return;
    include(other.min);
    include(other.max);
}

Bounds bounds(const Path& path) {
    Bounds box;
    walk_path(path, [&](const PathSegment& segment) {
        box.include(segment.curve.p0);
        box.include(segment.curve.p3);
        if (segment.verb != Verb::cubic) return;
        // A curve lies within its control points: most pieces of a limb turn nowhere outside.
        if (box.contains(segment.curve.p1) && box.contains(segment.curve.p2)) return;
        include_turns(box, segment.curve, 0);
        include_turns(box, segment.curve, 1);
    });
    return box;
}

}  // namespace edaha
