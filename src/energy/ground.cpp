// SPDX-License-Identifier: MIT
#include "energy/ground.h"

#include <algorithm>
#include <cmath>

#include "geometry/measure.h"

namespace edaha {
namespace {

struct Reach {
    double left = 0, right = 0, rise = 0, sink = 0;
};

// A flat lens, rounder below than above, that reaches so far from its middle.
void add_lens(Path& path, Vec2 middle, const Reach& reach) {
    const auto [left, right, rise, sink] = reach;
    const Vec2 a = middle - Vec2(left, 0), b = middle + Vec2(right, 0);
    const Vec2 top = middle - Vec2(0, rise), low = middle + Vec2(0, sink);
    path.move_to(a);
    path.cubic_to(a + Vec2(left * 0.10, -rise * 0.55), top - Vec2(left * 0.52, 0), top);
    path.cubic_to(top + Vec2(right * 0.52, 0), b + Vec2(-right * 0.10, -rise * 0.55), b);
    path.cubic_to(b + Vec2(-right * 0.06, sink * 0.62), low + Vec2(right * 0.55, 0), low);
    path.cubic_to(low - Vec2(left * 0.55, 0), a + Vec2(left * 0.06, sink * 0.62), a);
    path.close();
}

Path lens(Vec2 middle, const Reach& reach) {
    Path path;
    add_lens(path, middle, reach);
    return path;
}

// An oval of four quarters of ellipses.
Path oval(Vec2 middle, const Reach& reach) {
    constexpr double kArm = 0.5523;  // of the cubic nearest to a quarter of a circle
    const auto [left, right, rise, sink] = reach;
    const Vec2 a = middle - Vec2(left, 0), b = middle + Vec2(right, 0);
    const Vec2 top = middle - Vec2(0, rise), low = middle + Vec2(0, sink);
    Path path;
    path.move_to(a);
    path.cubic_to(a - Vec2(0, kArm * rise), top - Vec2(kArm * left, 0), top);
    path.cubic_to(top + Vec2(kArm * right, 0), b - Vec2(0, kArm * rise), b);
    path.cubic_to(b + Vec2(0, kArm * sink), low + Vec2(kArm * right, 0), low);
    path.cubic_to(low - Vec2(kArm * left, 0), a + Vec2(0, kArm * sink), a);
    path.close();
    return path;
}

Paint filled(Colour colour) {
    Paint paint;
    paint.fill = colour;
    return paint;
}

// The oval about the foot that all roots stand in.
Reach reach_of_roots(const Stand& stand) {
    Reach reach;
    for (const Footing& root : stand.roots) {
        const Vec2 off = root.middle - stand.foot;
        reach.left = std::max(reach.left, root.half_width_mm - off.x);
        reach.right = std::max(reach.right, off.x + root.half_width_mm);
        reach.rise = std::max(reach.rise, root.half_width_mm - off.y);
        reach.sink = std::max(reach.sink, off.y + root.half_width_mm);
    }
    // An oval with these reaches cuts off what stands in the corners.
    double farthest = 1;
    for (const Footing& root : stand.roots) {
        const Vec2 off = root.middle - stand.foot;
        const double x = off.x / (off.x < 0 ? reach.left : reach.right);
        const double y = off.y / (off.y < 0 ? reach.rise : reach.sink);
        farthest = std::max(farthest, std::sqrt(x * x + y * y));
    }
    const double room = 1.08 * farthest;
    return {room * reach.left, room * reach.right, room * reach.rise, room * reach.sink};
}

// Thin lenses that lie scattered over the water, the nearer the longer.
Path streaks(Vec2 middle, const Reach& reach) {
    constexpr int kStreaks = 14;
    constexpr double kGolden = 0.6180339887498949;  // spreads any number of places evenly
    Path path;
    for (int i = 0; i < kStreaks; ++i) {
        const double u = std::fmod(0.31 + i * kGolden, 1.0), v = (i + 0.5) / kStreaks;
        const double y = -0.82 * reach.rise + v * 0.82 * (reach.rise + reach.sink);
        // Within the lens, which narrows to its upper and lower edges.
        const double part = y / (y < 0 ? reach.rise : reach.sink);
        const double room = std::sqrt(1 - part * part);
        const double x = (u < 0.5 ? reach.left : reach.right) * (2 * u - 1) * 0.8 * room;
        const double half = (0.05 + 0.07 * v) * (reach.left + reach.right) * room;
        const double thick = 0.012 * (reach.rise + reach.sink) * (0.7 + v);
        add_lens(path, middle + Vec2(x, y), {half, half, thick, thick});
    }
    return path;
}

// Rings of light round what stands in the water, and what it throws on the near side.
void add_ripples(Layer& layer, const Stand& stand, const Palette& palette) {
    std::vector<Footing> standing = stand.roots;
    standing.push_back({stand.foot, stand.foot_width_mm / 2});
    Path rings, shades;
    for (const Footing& root : standing) {
        const double r = root.half_width_mm;
        if (!(r > 0)) continue;
        add_lens(shades, root.middle + Vec2(0.3 * r, 0.42 * r),
                 {1.7 * r, 2.1 * r, 0.42 * r, 0.5 * r});
        add_lens(rings, root.middle + Vec2(0, 0.1 * r), {3 * r, 3 * r, 0.62 * r, 0.8 * r});
        const Path inner =
            reversed(lens(root.middle + Vec2(0, 0.04 * r), {2.6 * r, 2.6 * r, 0.46 * r, 0.6 * r}));
        rings.verbs.insert(rings.verbs.end(), inner.verbs.begin(), inner.verbs.end());
        rings.points.insert(rings.points.end(), inner.points.begin(), inner.points.end());
    }
    if (rings.empty()) return;
    layer.children.emplace_back(
        Shape{"ripples", std::move(rings), filled(mixed(palette.ground, palette.paper, 0.55))});
    layer.children.emplace_back(
        Shape{"reflections", std::move(shades), filled(palette.ground_shade)});
}

void add_water(Layer& layer, const Stand& stand, Reach reach, const Palette& palette) {
    layer.children.emplace_back(Shape{"water", oval(stand.foot, reach), {}});
    layer.children.emplace_back(Shape{"waves", streaks(stand.foot, reach),
                                      filled(mixed(palette.ground, palette.ground_shade, 0.55))});
    add_ripples(layer, stand, palette);
}

// As much of the shapes as no root asks for.
void add_plain(Layer& layer, const Stand& stand, const Reach& wide, double depth,
               const LookParams& look, const Palette& palette) {
    const auto reach = [&](double left, double right, double rise, double sink) {
        return Reach{left * wide.left, right * wide.right, rise * depth, sink * depth};
    };
    if (look.ground == Ground::mound) {
        layer.children.emplace_back(
            Shape{"mound", lens(stand.foot + Vec2(0, depth * 0.5), reach(1, 1, 0.75, 0.8)), {}});
        layer.children.emplace_back(Shape{
            "shadow",
            lens(stand.foot + Vec2(wide.right * 0.06, depth * 0.42), reach(0.5, 0.62, 0.3, 0.34)),
            filled(palette.ground_shade)});
        return;
    }
    layer.children.emplace_back(
        Shape{"shadow", lens(stand.foot + Vec2(0, depth * 0.12), reach(1, 1, 0.42, 0.5)), {}});
}

// Under roots: an oval, and the shade of what they carry.
void add_under_roots(Layer& layer, const Stand& stand, const Reach& reach, const LookParams& look,
                     const Palette& palette) {
    const char* const name = look.ground == Ground::mound ? "mound" : "shadow";
    layer.children.emplace_back(Shape{name, oval(stand.foot, reach), {}});
    if (look.ground != Ground::mound) return;
    const Reach shade{0.6 * reach.left, 0.7 * reach.right, 0.55 * reach.rise, 0.6 * reach.sink};
    layer.children.emplace_back(
        Shape{"shade", oval(stand.foot, shade), filled(palette.ground_shade)});
}

}  // namespace

Layer draw_ground(const Stand& stand, const LookParams& look, const Palette& palette) {
    Layer layer{"Ground", {}, {}};
    layer.paint.fill = palette.ground;
    if (look.ground == Ground::none) return layer;
    // At least as wide as the foot wants to stand on.
    const double least = stand.foot_width_mm * 0.9;
    Reach wide;
    wide.left = std::max((stand.foot.x - stand.crown_left_mm) * look.ground_width, least);
    wide.right = std::max((stand.crown_right_mm - stand.foot.x) * look.ground_width, least);
    const double depth = std::min(0.05 * (wide.left + wide.right), 1.1 * stand.foot_width_mm);
    if (stand.roots.empty() && look.ground != Ground::water) {
        add_plain(layer, stand, wide, depth, look, palette);
        return layer;
    }
    Reach reach = reach_of_roots(stand);
    reach = {std::max(reach.left, wide.left), std::max(reach.right, wide.right),
             std::max(reach.rise, 0.45 * depth), std::max(reach.sink, 0.55 * depth)};
    if (look.ground == Ground::water) {
        // Room for the ripples round the trunk.
        const double r = stand.foot_width_mm / 2;
        reach = {std::max(reach.left, 4.5 * r), std::max(reach.right, 4.5 * r),
                 std::max(reach.rise, 0.9 * r), std::max(reach.sink, 1.3 * r)};
        add_water(layer, stand, reach, palette);
    } else {
        add_under_roots(layer, stand, reach, look, palette);
    }
    return layer;
}

}  // namespace edaha
