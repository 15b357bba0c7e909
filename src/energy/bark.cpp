// SPDX-License-Identifier: MIT
#include "energy/bark.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "energy/outline.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

// Limbs thinner than this show no shaded side: it would be a hair.
constexpr double kShadeWidthMm = 2.2;
constexpr Vec2 kTowardsLight{-0.6, -0.8};

// The band between a flank and a line inside the limb, from where the shade sets in to where it
// has run out. `lit` is the side of the light; the band lies on the other.
void add_band(Path& shade, const std::vector<LimbSection>& run, int side,
              const std::vector<double>& depth) {
    std::vector<CurveSample> flank, inner;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const CurveSample outside = run[i].sample(side * 0.985);
        const double across = side * (0.985 - depth[i]);
        CurveSample inside = run[i].sample(across);
        if (glm::length(outside.tangent) == 0 || glm::length(inside.tangent) == 0) continue;
        flank.push_back(outside);
        inner.push_back(inside);
    }
    if (flank.size() < 4) return;
    // The inner line's own direction: its depth changes along the limb.
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const Vec2 before = inner[i > 0 ? i - 1 : 0].position;
        const Vec2 after = inner[std::min(i + 1, inner.size() - 1)].position;
        if (glm::distance(before, after) > 1e-9) inner[i].tangent = after - before;
    }
    inner.front().position = flank.front().position;
    inner.back().position = flank.back().position;
    const double ends = glm::distance(flank.front().position, flank.back().position);
    if (ends < 1) return;  // a speck
    std::reverse(inner.begin(), inner.end());
    for (CurveSample& sample : inner)
        sample.tangent = -sample.tangent;
    Path band;
    band.move_to(flank.front().position);
    for (const Cubic& c : fit_cubics(flank, 0.05))
        band.cubic_to(c.p1, c.p2, c.p3);
    for (const Cubic& c : fit_cubics(inner, 0.08))
        band.cubic_to(c.p1, c.p2, c.p3);
    band.points.back() = band.points.front();  // the fit's own ends are an ulp off
    band.close();
    if (signed_area(band) < 0) band = reversed(band);
    shade.verbs.insert(shade.verbs.end(), band.verbs.begin(), band.verbs.end());
    shade.points.insert(shade.points.end(), band.points.begin(), band.points.end());
}

double smooth(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

Path draw_shade(const LimbCurve& curve, const Limb& limb) {
    const double widest = curve.section({0, 0}).half_width;
    Path shade;
    if (2 * widest < kShadeWidthMm) return shade;
    std::vector<LimbSection> run;
    std::vector<double> depth;
    int side = 0;
    const auto finish = [&] {
        if (run.size() >= 4) add_band(shade, run, side, depth);
        run.clear(), depth.clear();
    };
    const double start_mm = limb.parent < 0 ? -0.3 * widest : 3 * widest;
    double along = 0;
    for (std::size_t span = 0; span < curve.spans(); ++span) {
        for (int i = 0; i < 6; ++i) {
            const double t = i / 6.0;
            const LimbSection section = curve.section({span, t});
            const double at = along + t * curve.chord_mm(span);
            // How much of the light the right-hand side gets: -1 … 1.
            const double lit = glm::dot(section.normal(), kTowardsLight);
            const double fade =
                smooth((2 * section.half_width - 0.7 * kShadeWidthMm) / (0.5 * kShadeWidthMm)) *
                smooth((at - start_mm) / (3 * widest));
            const double now = fade * smooth((std::abs(lit) - 0.15) / 0.5) * 0.62;
            const int shaded = lit > 0 ? -1 : 1;
            if (now < 0.03 || (side != shaded && !run.empty())) finish();
            side = shaded;
            if (now < 0.03) continue;
            run.push_back(section);
            depth.push_back(now);
        }
        along += curve.chord_mm(span);
    }
    finish();
    return shade;
}

// A mark runs in from one flank and thins out to a point: two cubics.
void add_mark(Path& marks, const LimbCurve& curve, LimbPlace place, const KeyedRandom& random,
              Key key) {
    const LimbSection section = curve.section(place);
    const int side = random.uniform(key, 120) < 0.5 ? 1 : -1;
    const double reach = 0.35 + 0.75 * random.uniform(key, 121);
    const double height = section.half_width * (0.10 + 0.14 * random.uniform(key, 122));
    const Vec2 up = section.tangent * height;
    const Vec2 start = section.at(side * 0.97), end = section.at(side * (0.97 - reach));
    const Vec2 sag = -section.tangent * (section.half_width * 0.18 * reach);
    Path mark;
    mark.move_to(start + up);
    mark.cubic_to(start + (end - start) * 0.35 + up * 0.7 + sag,
                  start + (end - start) * 0.7 + up * 0.4 + sag, end);
    mark.cubic_to(start + (end - start) * 0.7 - up * 0.5 + sag,
                  start + (end - start) * 0.35 - up * 0.9 + sag, start - up);
    mark.close();
    if (signed_area(mark) < 0) mark = reversed(mark);
    marks.verbs.insert(marks.verbs.end(), mark.verbs.begin(), mark.verbs.end());
    marks.points.insert(marks.points.end(), mark.points.begin(), mark.points.end());
}

Path draw_marks(const LimbCurve& curve, const Limb& limb, const LookParams& look) {
    Path marks;
    if (look.marks <= 0) return marks;
    const KeyedRandom random(0, 0, 0);  // the member's seed is in the key
    const double length = curve.length_mm(0, curve.spans());
    Key key = step(limb.member_key, 0x6d61726b);
    const double pitch = 10 / look.marks;
    for (double s = pitch; s < length; s += pitch * (0.5 + random.uniform(key, 123))) {
        key = step(key, 1);
        const LimbPlace place = curve.walk(0, s);
        if (2 * curve.section(place).half_width < look.mark_min_width_mm) break;
        add_mark(marks, curve, place, random, key);
    }
    return marks;
}

}  // namespace

Bark draw_bark(const Limbs& limbs, const Limb& limb, const LookParams& look) {
    if (look.straight) return {};
    const LimbCurve curve = curve_of(limbs, limb, look);
    return {draw_shade(curve, limb), draw_marks(curve, limb, look)};
}

}  // namespace edaha
