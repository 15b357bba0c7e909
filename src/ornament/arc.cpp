// SPDX-License-Identifier: MIT
#include "ornament/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/stable_math.h"

namespace edaha {
namespace {

constexpr double kPi = std::numbers::pi;

// Page from the circle of radius 1 that is the ellipse, and the arc's angles on it.
struct CentredArc {
    Affine page_from_circle;
    double start_rad;
    double turn_rad;
};

// SVG 1.1, F.6.5 and F.6.6: with the ellipse made a unit circle, the chord's half `h` gives the
// centre at a distance sqrt(1 - |h|^2) on the chord's normal.
CentredArc centred(const EllipseArc& arc) {
    const auto [sin, cos] = stable::sin_cos(std::fmod(arc.x_axis_deg, 360) * (kPi / 180));
    const Vec2 half = (arc.to - arc.from) * 0.5;
    Vec2 radii(std::abs(arc.radii.x), std::abs(arc.radii.y));
    Vec2 h((cos * half.x + sin * half.y) / radii.x, (-sin * half.x + cos * half.y) / radii.y);
    double h2 = h.x * h.x + h.y * h.y;
    if (h2 > 1) {  // F.6.6.3: the smallest ellipse that reaches
        radii *= std::sqrt(h2);
        h /= std::sqrt(h2);
        h2 = 1;
    }
    const double off = std::sqrt(std::max(0.0, 1 - h2) / h2) * (arc.large == arc.sweep ? -1 : 1);
    const Vec2 centre = Vec2(-h.y, h.x) * off;  // from the chord's middle
    const double start = stable::atan2(-h.y - centre.y, -h.x - centre.x);
    double turn = stable::atan2(h.y - centre.y, h.x - centre.x) - start;
    if (arc.sweep && turn < 0) turn += 2 * kPi;
    if (!arc.sweep && turn > 0) turn -= 2 * kPi;
    Affine page(Vec2(cos, sin) * radii.x, Vec2(-sin, cos) * radii.y, Vec2(0));
    page[2] = (arc.from + arc.to) * 0.5 + transform(page, centre);
    return {page, start, turn};
}

}  // namespace

void add_arc(Path& path, const EllipseArc& arc) {
    constexpr double kNoRadius = 1e-100;  // the squares of chord / radius stay finite above it
    if (arc.from == arc.to) return;
    if (std::abs(arc.radii.x) < kNoRadius || std::abs(arc.radii.y) < kNoRadius) {
        path.line_to(arc.to);
        return;
    }
    const auto [page_from_circle, start, turn] = centred(arc);
    // A quarter turn made a little too long by rounding stays one piece.
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / (kPi / 2) - 1e-9)));
    const double step = turn / pieces;
    const auto quarter = stable::sin_cos(step / 4);
    const double arm = 4.0 / 3.0 * quarter.sin / quarter.cos;
    for (int i = 0; i < pieces; ++i) {
        const auto a = stable::sin_cos(start + i * step);
        const auto b = stable::sin_cos(start + (i + 1) * step);
        const Vec2 end = transform(page_from_circle, {b.cos, b.sin});
        path.cubic_to(transform(page_from_circle, {a.cos - arm * a.sin, a.sin + arm * a.cos}),
                      transform(page_from_circle, {b.cos + arm * b.sin, b.sin - arm * b.cos}),
                      i + 1 == pieces ? arc.to : end);
    }
}

}  // namespace edaha
