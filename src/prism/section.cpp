// SPDX-License-Identifier: MIT
#include "prism/section.h"

#include <algorithm>
#include <cmath>

namespace edaha {
namespace {

Section centred(const Section& section) {
    return moved(section, -centroid(section));
}

}  // namespace

double area(const Section& section) {
    const auto& [p, q, r] = section.corners;
    const Vec2 u = q - p, v = r - p;
    return (u.y * v.x - u.x * v.y) / 2;
}

Vec2 centroid(const Section& section) {
    const auto& [p, q, r] = section.corners;
    return (p + q + r) / 3.0;
}

Section moved(Section section, Vec2 by) {
    for (Vec2& corner : section.corners)
        corner += by;
    return section;
}

Section scaled(Section section, double factor) {
    for (Vec2& corner : section.corners)
        corner *= factor;
    return section;
}

std::size_t longest_side(const Section& section) {
    std::size_t best = 0;
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 side = section.corners[(i + 1) % 3] - section.corners[i];
        const double squared = side.x * side.x + side.y * side.y;
        if (squared > longest) longest = squared, best = i;
    }
    return best;
}

Halves halve(const Section& section, std::size_t side, double at) {
    const Vec2 from = section.corners[side], to = section.corners[(side + 1) % 3];
    const Vec2 opposite = section.corners[(side + 2) % 3];
    const Vec2 cut = from + at * (to - from);
    const Section a{{opposite, from, cut}}, b{{opposite, cut, to}};
    return {centred(a), centred(b), centroid(a), centroid(b)};
}

Section equilateral(double radius) {
    const double x = radius * std::sqrt(0.75), z = radius / 2;
    return {{Vec2(0, radius), Vec2(x, -z), Vec2(-x, -z)}};
}

Section by_sides(double a, double b, double c) {
    // Corner 2 from the law of cosines; behind the first side, so that the corners run the right
    // way.
    const double x = (a * a + c * c - b * b) / (2 * a);
    const double z = std::sqrt(std::max(c * c - x * x, 0.0));
    return centred({{Vec2(0, 0), Vec2(a, 0), Vec2(x, -z)}});
}

}  // namespace edaha
