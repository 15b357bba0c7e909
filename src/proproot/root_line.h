// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "proproot/prop_roots.h"

namespace edaha {

// A place on a root's middle line.
struct LinePoint {
    Vec3 position{0};
    double along = 0;  // length from the branching point; below 0 inside the trunk
    double radius = 0;
};

// A root's middle line from its start to its end, as the tube and the search for collisions take
// it. All points lie on the catenary but the first of a primary, which lies inside the trunk.
// Points are set by equal bends, `curve_points` for a right angle, more at the knob and the tip,
// and fewer where a circle would cut into the next one: no bend is tighter than the tube is wide.
std::vector<LinePoint> root_line(const PropRoot& root, const PropRootParams& params);

}  // namespace edaha
