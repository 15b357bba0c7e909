// SPDX-License-Identifier: MIT
#include "energy/ground.h"

#include <algorithm>

namespace edaha {
namespace {

// A flat lens, rounder below than above, of `left` and `right` reach from its middle.
Path lens(Vec2 middle, double left, double right, double rise, double sink) {
    const Vec2 a = middle - Vec2(left, 0), b = middle + Vec2(right, 0);
    const Vec2 top = middle - Vec2(0, rise), low = middle + Vec2(0, sink);
    Path path;
    path.move_to(a);
    path.cubic_to(a + Vec2(left * 0.10, -rise * 0.55), top - Vec2(left * 0.52, 0), top);
    path.cubic_to(top + Vec2(right * 0.52, 0), b + Vec2(-right * 0.10, -rise * 0.55), b);
    path.cubic_to(b + Vec2(-right * 0.06, sink * 0.62), low + Vec2(right * 0.55, 0), low);
    path.cubic_to(low - Vec2(left * 0.55, 0), a + Vec2(left * 0.06, sink * 0.62), a);
    path.close();
    return path;
}

}  // namespace

Layer draw_ground(const Stand& stand, const LookParams& look, const Palette& palette) {
    Layer layer{"Ground", {}, {}};
    layer.paint.fill = palette.ground;
    if (look.ground == Ground::none) return layer;
    // At least as wide as the foot wants to stand on.
    const double least = stand.foot_width_mm * 0.9;
    const double left = std::max((stand.foot.x - stand.crown_left_mm) * look.ground_width, least);
    const double right = std::max((stand.crown_right_mm - stand.foot.x) * look.ground_width, least);
    const double depth = std::min(0.05 * (left + right), 1.1 * stand.foot_width_mm);
    if (look.ground == Ground::mound) {
        layer.children.emplace_back(
            Shape{"mound",
                  lens(stand.foot + Vec2(0, depth * 0.5), left, right, depth * 0.75, depth * 0.8),
                  {}});
        Paint shade;
        shade.fill = palette.ground_shade;
        layer.children.emplace_back(Shape{"shadow",
                                          lens(stand.foot + Vec2(right * 0.06, depth * 0.42),
                                               left * 0.5, right * 0.62, depth * 0.3, depth * 0.34),
                                          shade});
        return layer;
    }
    layer.children.emplace_back(
        Shape{"shadow",
              lens(stand.foot + Vec2(0, depth * 0.12), left, right, depth * 0.42, depth * 0.5),
              {}});
    return layer;
}

}  // namespace edaha
