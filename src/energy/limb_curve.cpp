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

// One span of the limb, at parameter t: in Hermite form, position, width and their derivatives.
struct LimbCurve::Span {
    Span(const LimbNode& from, const LimbNode& to, double at)
        : a(from),
          h(from.chord),
          t(at),
          u(1 - at),
          rise(to.position - from.position),
          va(from.velocity * h),
          vb(to.velocity * h),
          w(to.half_width - from.half_width),
          ta(from.taper * h),
          tb(to.taper * h) {}

    Vec2 position() const {
        return a.position + rise * (t * t * (3 - 2 * t)) + va * (t * u * u) - vb * (t * t * u);
    }
    Vec2 first() const {
        return rise * (6 * t * u) + va * (u * (1 - 3 * t)) + vb * (t * (3 * t - 2));
    }
    Vec2 second() const { return rise * (6 - 12 * t) + va * (6 * t - 4) + vb * (6 * t - 2); }
    double half_width() const {
        return a.half_width + w * (t * t * (3 - 2 * t)) + ta * (t * u * u) - tb * (t * t * u);
    }
    double width_slope() const {
        return w * (6 * t * u) + ta * (u * (1 - 3 * t)) + tb * (t * (3 * t - 2));
    }

    const LimbNode& a;
    double h, t, u;
    Vec2 rise, va, vb;
    double w, ta, tb;
};

// What is left of the flare at a place, 1 at the foot to 0.
double LimbCurve::flare_left(LimbPlace place) const {
    if (!(flare_ > 0) || place.span > 1) return 0;
    const double along = (place.span == 1 ? chord_mm(0) : 0) + chord_mm(place.span) * place.t;
    return std::max(1 - along / flare_height_mm_, 0.0);
}

LimbSection LimbCurve::section(LimbPlace place) const {
    const Span span(nodes_[place.span], nodes_[place.span + 1], place.t);
    LimbSection section;
    section.centre = span.position();
    const Vec2 d1 = span.first();
    const double speed = std::max(glm::length(d1), 1e-9 * span.h);
    section.tangent = d1 / speed;
    section.curvature = cross(d1, span.second()) / (speed * speed * speed);
    section.half_width = span.half_width();
    section.taper = span.width_slope() / speed;
    if (const double left = flare_left(place); left > 0) {
        // The fourth power sets out at a slant from the ground and melts into the trunk.
        const double widening = 1 + flare_ * left * left * left * left;
        section.taper = section.taper * widening -
                        section.half_width * flare_ * 4 * left * left * left / flare_height_mm_;
        section.half_width *= widening;
    }
    return section;
}

LimbSlice LimbCurve::slice(LimbPlace place) const {
    const Span span(nodes_[place.span], nodes_[place.span + 1], place.t);
    const Vec2 d1 = span.first();
    LimbSlice slice{span.position(), d1 / std::max(glm::length(d1), 1e-9 * span.h),
                    span.half_width()};
    const double left = flare_left(place);
    if (left > 0) slice.half_width *= 1 + flare_ * left * left * left * left;
    return slice;
}

LimbSlice LimbCurve::slice_at_node(std::size_t node) const {
    return node < spans() ? slice({node, 0}) : slice({spans() - 1, 1});
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
