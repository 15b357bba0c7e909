// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "geometry/path.h"

namespace edaha {

// Cubic Bézier curve, parameter 0 at p0 and 1 at p3.
struct Cubic {
    Vec2 p0, p1, p2, p3;
};

inline Vec2 eval(const Cubic& c, double t) {
    const double u = 1 - t;
    return (u * u * u) * c.p0 + (3 * u * u * t) * c.p1 + (3 * u * t * t) * c.p2 +
           (t * t * t) * c.p3;
}

// With respect to t; three times an arm at the ends.
inline Vec2 derivative(const Cubic& c, double t) {
    const double u = 1 - t;
    return (3 * u * u) * (c.p1 - c.p0) + (6 * u * t) * (c.p2 - c.p1) + (3 * t * t) * (c.p3 - c.p2);
}

// The way the curve runs at its ends, of length 1, also where an arm has none; 0 for a point.
Vec2 start_direction(const Cubic& c);
inline Vec2 end_direction(const Cubic& c) {
    return -start_direction({c.p3, c.p2, c.p1, c.p0});
}

// Both parts meet in exactly the same point.
std::array<Cubic, 2> split(const Cubic& curve, double t);

// The part from t0 to t1, run backwards if t0 > t1. At 0 and 1 the ends are the curve's own.
Cubic sub_cubic(const Cubic& curve, double t0, double t1);

inline Cubic reversed(const Cubic& c) {
    return {c.p3, c.p2, c.p1, c.p0};
}

// Equal parameter steps that keep every chord within `tolerance` of the curve (Wang's bound on
// the second differences of the control points). At least 1, at most 4096.
int flatten_steps(const Cubic& curve, double tolerance);

// The points at those steps, both ends included.
std::vector<Vec2> flatten(const Cubic& curve, double tolerance);

// Relative error below 1e-6 but at cusps (5-point Gauss-Legendre, halved where two halves differ
// from the whole).
double arc_length(const Cubic& curve);

}  // namespace edaha
