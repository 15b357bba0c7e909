// SPDX-License-Identifier: MIT
#include "geometry/refine_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

// Chords cut a crossing at angle a within tolerance / sin a of its place: this covers crossings
// from 4 degrees on. Flatter ones may lie further off than their neighbours.
constexpr double kReach = 16;

struct Parameters {
    double s = 0, t = 0;
};

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// Parameters at which the two curves come within `precision` of each other.
std::optional<Parameters> find_crossing(const Cubic& a, const Cubic& b, Parameters at,
                                        double precision) {
    for (int i = 0; i < 10; ++i) {
        const Vec2 miss = eval(b, at.t) - eval(a, at.s);
        if (glm::dot(miss, miss) <= precision * precision) return at;
        const Vec2 along = derivative(a, at.s), other = -derivative(b, at.t);
        const double det = cross(along, other);
        if (det == 0) return std::nullopt;
        at.s = std::clamp(at.s + cross(miss, other) / det, 0.0, 1.0);
        at.t = std::clamp(at.t + cross(along, miss) / det, 0.0, 1.0);
    }
    return std::nullopt;
}

void refine(const Chords& chords, BorderRun& run, BorderRun& next, double tolerance) {
    // Entered backwards: the curve that the run has been on.
    const CurvePlace end = curve_place(chords, run.ring, run.end, !run.forward);
    const CurvePlace begin = curve_place(chords, next.ring, next.begin, next.forward);
    const SourceCurve& a = chords.curves[end.curve];
    const SourceCurve& b = chords.curves[begin.curve];
    // Where lines cross the grid has the crossing already; one curve doesn't cross itself here.
    if ((a.straight && b.straight) || end.curve == begin.curve) return;
    const auto found = find_crossing(a.cubic, b.cubic, {end.t, begin.t}, chords.grid * 0.125);
    if (!found) return;
    const Vec2 place = eval(a.cubic, found->s) / chords.grid;
    if (glm::distance(place, to_vec(run.stop)) > kReach * tolerance / chords.grid + 2) return;
    const double run_end = end.first + found->s * a.chords;
    const double next_begin = begin.first + found->t * b.chords;
    // Neither run may vanish or turn round.
    if ((run_end > run.begin) != run.forward || (next.end > next_begin) != next.forward) return;
    run.end = run_end;
    next.begin = next_begin;
    run.stop = next.start = {static_cast<std::int32_t>(std::floor(place.x + 0.5)),
                             static_cast<std::int32_t>(std::floor(place.y + 0.5))};
}

}  // namespace

std::vector<BorderRun> refine_crossings(const Chords& chords, std::vector<BorderRun> runs,
                                        double tolerance) {
    if (runs.size() < 2) return runs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        refine(chords, runs[i], runs[(i + 1) % runs.size()], tolerance);
    }
    return runs;
}

}  // namespace edaha
