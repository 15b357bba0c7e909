// SPDX-License-Identifier: MIT
#include <cmath>

#include "geometry/cover.h"
#include "geometry/measure.h"
#include "geometry/unite.h"

namespace edaha {
namespace {

// The area between a part of the chord's curve and that part's own chord, positive to the left of
// the half-edge, which runs from `from` to `to`.
double cap_area(const Chords& chords, std::uint32_t chord, GridPoint from, GridPoint to) {
    const SourceCurve& curve = chords.curves[chords.curve_of[chord]];
    if (curve.straight) return 0;
    const GridSegment& segment = chords.segments[chord];
    const double before = chord - curve.first_chord;
    const double t0 = (before + fraction_at(segment, from)) / curve.chords;
    const double t1 = (before + fraction_at(segment, to)) / curve.chords;
    const Cubic c = sub_cubic(curve.cubic, t0, t1);
    return swept_area({Vec2(0), c.p1 - c.p0, c.p2 - c.p0, c.p3 - c.p0});
}

}  // namespace

double area_of_union(std::span<const Path> closed, double tolerance) {
    // An eighth of the tolerance or a little less: rounding then disappears beside it.
    const Cover cover =
        cover_plane(closed, {tolerance, std::exp2(std::floor(std::log2(tolerance / 8)))});
    const PlanarMap& map = cover.map;
    const Chords& chords = cover.chords;
    double squares = 0;
    for (std::uint32_t face = 1; face < map.faces(); ++face) {
        if (cover.covered[face]) squares += face_area(map, face);
    }
    double caps = 0;
    for (std::uint32_t h = 0; h < map.next.size(); ++h) {
        if (!cover.covered[map.face_of(h)] || cover.covered[map.face_of(twin(h))]) continue;
        const EdgeUse use = cover.arrangement.uses_of(h / 2).front();
        caps += cap_area(chords, use.segment, map.nodes[map.origin(h)], map.nodes[map.target(h)]);
    }
    return squares * chords.grid * chords.grid + caps;
}

}  // namespace edaha
