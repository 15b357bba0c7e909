// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "geometry/path.h"

namespace edaha {

// One stroke of a bark tile: a polyline with a width at each of its points. Two points at least.
struct BarkLine {
    std::vector<Vec2> points;
    std::vector<double> widths_mm;
    bool light = false;  // a ridge in the light, else a furrow in the shade
};

// A piece of bark that repeats without a seam both ways: strokes that overrun an edge go on in the
// next copy. y points up, along the branch. The first lines count most: they stay where there is
// room for few.
struct BarkTile {
    double width_mm = 0;   // the period round the branch
    double height_mm = 0;  // along it
    std::vector<BarkLine> lines;
    bool empty() const { return lines.empty(); }
};

}  // namespace edaha
