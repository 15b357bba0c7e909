// SPDX-License-Identifier: MIT
#include "energy/limb_curve.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

CurveSample LimbSection::sample(double across) const {
    const double offset = half_width * across;
    // d/ds (c + o n) = (1 - o k) t + o' n
    const double forward = 1 - offset * curvature;
    const Vec2 direction = tangent * forward + normal() * (taper * across);
    // Inside a bend tighter than the limb is wide the flank runs backwards: no sample there.
    return {at(across), forward > 0.05 ? direction : Vec2(0, 0)};
}

LimbSection LimbCurve::section(LimbPlace place) const {
    const LimbNode& a = nodes_[place.span];
    const LimbNode& b = nodes_[place.span + 1];
    const double h = chord_mm(place.span), t = place.t, u = 1 - t;
    const Vec2 rise = b.position - a.position;
    const Vec2 va = a.velocity * h, vb = b.velocity * h;
    // Hermite form in t: position, first and second derivative.
    LimbSection section;
    section.centre =
        a.position + rise * (t * t * (3 - 2 * t)) + va * (t * u * u) - vb * (t * t * u);
    const Vec2 d1 = rise * (6 * t * u) + va * (u * (1 - 3 * t)) + vb * (t * (3 * t - 2));
    const Vec2 d2 = rise * (6 - 12 * t) + va * (6 * t - 4) + vb * (6 * t - 2);
    const double speed = std::max(glm::length(d1), 1e-9 * h);
    section.tangent = d1 / speed;
    section.curvature = cross(d1, d2) / (speed * speed * speed);
    const double w = b.half_width - a.half_width;
    const double ta = a.taper * h, tb = b.taper * h;
    section.half_width =
        a.half_width + w * (t * t * (3 - 2 * t)) + ta * (t * u * u) - tb * (t * t * u);
    section.taper = (w * (6 * t * u) + ta * (u * (1 - 3 * t)) + tb * (t * (3 * t - 2))) / speed;
    if (flare_ > 0 && place.span <= 1) {
        const double along = (place.span == 1 ? chord_mm(0) : 0) + h * t;
        const double left = 1 - along / flare_height_mm_;
        if (left > 0) {
            // The fourth power sets out at a slant from the ground and melts into the trunk.
            const double widening = 1 + flare_ * left * left * left * left;
            section.taper = section.taper * widening -
                            section.half_width * flare_ * 4 * left * left * left / flare_height_mm_;
            section.half_width *= widening;
        }
    }
    return section;
}

LimbSection LimbCurve::section_at_node(std::size_t node) const {
    return node < spans() ? section({node, 0}) : section({spans() - 1, 1});
}

LimbPlace LimbCurve::walk(std::size_t node, double distance_mm) const {
    if (distance_mm >= 0) {
        for (std::size_t span = node; span < spans(); ++span) {
            const double chord = chord_mm(span);
            if (distance_mm <= chord) return {span, distance_mm / chord};
            distance_mm -= chord;
        }
        return {spans() - 1, 1};
    }
    for (std::size_t span = node; span-- > 0;) {
        const double chord = chord_mm(span);
        if (-distance_mm <= chord) return {span, 1 + distance_mm / chord};
        distance_mm += chord;
    }
    return {0, 0};
}

double LimbCurve::length_mm(std::size_t from_node, std::size_t to_node) const {
    double length = 0;
    for (std::size_t span = from_node; span < to_node; ++span)
        length += chord_mm(span);
    return length;
}

}  // namespace edaha
