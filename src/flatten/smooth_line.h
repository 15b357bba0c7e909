// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "geometry/bezier.h"

namespace edaha {

// A piece of a curve that stands for a part of a polyline.
struct CurvePiece {
    Cubic curve;
    bool straight = false;  // control points at the thirds
    double end = 0;         // the polyline's length up to where the piece ends
};

struct SmoothParams {
    double tolerance = 0.5;  // how far the curve may be from the polyline
    double noise = 0.03;     // vertices that stick out less than this don't count
    bool straight = false;   // lines only, as close to the polyline as `noise`
};

// A polyline as few G1 cubics and straight lines, in its own units (pixels). A vertex is a corner
// if the line turns there and not round it, judged over kWindow on both sides: the zigzag of a
// mesh's contour is none. Edges from which a smooth curve would be further away than the tolerance
// stay straight. Both ends are pinned. Of a closed polyline (first point = last) the curve goes on
// smoothly through the seam, unless that is a corner. Two different points at least.
// About a microsecond a pixel of curve, far less for straight lines.
std::vector<CurvePiece> smooth_line(std::span<const Vec2> points, bool closed,
                                    const SmoothParams& params);

// The vertex of a closed polyline at which it turns most, judged the same way: the best seam.
std::size_t sharpest_vertex(std::span<const Vec2> points);

}  // namespace edaha
