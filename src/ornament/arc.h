// SPDX-License-Identifier: MIT
#pragma once
#include "geometry/path.h"

namespace edaha {

// SVG's elliptical arc by its ends (SVG 1.1, 8.3.8).
struct EllipseArc {
    Vec2 from, to;
    Vec2 radii;             // signs don't matter
    double x_axis_deg = 0;  // of the ellipse's x axis, from +x to +y
    bool large = false;
    bool sweep = false;  // the way from +x to +y
};

// Draws it with cubics of at most a quarter turn each; `path` ends in arc.from. Radii too small
// are scaled up, a radius of 0 gives a line (SVG 1.1, F.6.2); equal ends give nothing. Each cubic
// is off the ellipse by at most 2.73e-4 of the radius, outwards.
void add_arc(Path& path, const EllipseArc& arc);

}  // namespace edaha
