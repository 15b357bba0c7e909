// SPDX-License-Identifier: MIT
#include "geometry/bezier.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

Vec2 mix(Vec2 a, Vec2 b, double t) {
    return a * (1 - t) + b * t;
}

// Gauss-Legendre, 5 points, on [t0, t1].
double gauss_length(const Cubic& curve, double t0, double t1) {
    static constexpr double kAbscissa[] = {0, 0.5384693101056831, 0.9061798459386640};
    static constexpr double kWeight[] = {0.5688888888888889, 0.4786286704993665,
                                         0.2369268850561891};
    const double centre = (t0 + t1) * 0.5;
    const double half = (t1 - t0) * 0.5;
    double sum = kWeight[0] * glm::length(derivative(curve, centre));
    for (int i = 1; i < 3; ++i) {
        sum += kWeight[i] * (glm::length(derivative(curve, centre - half * kAbscissa[i])) +
                             glm::length(derivative(curve, centre + half * kAbscissa[i])));
    }
    return sum * half;
}

double refined_length(const Cubic& curve, double t0, double t1, double whole, int depth) {
    const double middle = (t0 + t1) * 0.5;
    const double first = gauss_length(curve, t0, middle);
    const double second = gauss_length(curve, middle, t1);
    // 12 halvings reach 1/4096 of the parameter: beyond that only a cusp is left.
    if (depth == 12 || std::abs(first + second - whole) <= 1e-7 * (first + second)) {
        return first + second;
    }
    return refined_length(curve, t0, middle, first, depth + 1) +
           refined_length(curve, middle, t1, second, depth + 1);
}

}  // namespace

Vec2 start_direction(const Cubic& c) {
    for (const Vec2 p : {c.p1, c.p2, c.p3}) {
        const double length = glm::distance(p, c.p0);
        if (length > 1e-9) return (p - c.p0) / length;
    }
    return Vec2(0);
}

std::array<Cubic, 2> split(const Cubic& c, double t) {
    const Vec2 a = mix(c.p0, c.p1, t), b = mix(c.p1, c.p2, t), d = mix(c.p2, c.p3, t);
    const Vec2 ab = mix(a, b, t), bd = mix(b, d, t);
    const Vec2 middle = mix(ab, bd, t);
    return {Cubic{c.p0, a, ab, middle}, Cubic{middle, bd, d, c.p3}};
}

Cubic sub_cubic(const Cubic& curve, double t0, double t1) {
    if (t0 > t1) return reversed(sub_cubic(curve, t1, t0));
    Cubic part = curve;
    if (t1 < 1) part = split(part, t1)[0];
    if (t0 > 0) part = split(part, t1 > 0 ? t0 / t1 : 0)[1];
    return part;
}

int flatten_steps(const Cubic& c, double tolerance) {
    const Vec2 first = c.p0 - 2.0 * c.p1 + c.p2;
    const Vec2 second = c.p1 - 2.0 * c.p2 + c.p3;
    const double bend = std::sqrt(std::max(glm::dot(first, first), glm::dot(second, second)));
    const double steps = std::ceil(std::sqrt(0.75 * bend / tolerance));
    return static_cast<int>(std::clamp(steps, 1.0, 4096.0));
}

std::vector<Vec2> flatten(const Cubic& curve, double tolerance) {
    const int steps = flatten_steps(curve, tolerance);
    std::vector<Vec2> points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    points.push_back(curve.p0);
    for (int i = 1; i < steps; ++i) {
        points.push_back(eval(curve, static_cast<double>(i) / steps));
    }
    points.push_back(curve.p3);
    return points;
}

double arc_length(const Cubic& curve) {
    return refined_length(curve, 0, 1, gauss_length(curve, 0, 1), 0);
}

}  // namespace edaha
