// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

#include "geometry/path.h"

namespace edaha {

// Axis-parallel box. Starts empty; an empty box has width and height 0 and includes nothing.
struct Bounds {
    Vec2 min{std::numeric_limits<double>::infinity()};
    Vec2 max{-std::numeric_limits<double>::infinity()};

    bool empty() const { return min.x > max.x; }
    double width() const { return empty() ? 0 : max.x - min.x; }
    double height() const { return empty() ? 0 : max.y - min.y; }
    Vec2 centre() const { return (min + max) * 0.5; }

    void include(Vec2 p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    void include(const Bounds& other);
    bool contains(Vec2 p) const {
        return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
    }
    bool overlaps(const Bounds& other) const {
        return min.x <= other.max.x && max.x >= other.min.x && min.y <= other.max.y &&
               max.y >= other.min.y;
    }
};

// The box of the drawn curve (not of its control points), from the extrema of each cubic.
// Strokes are not counted. A path without segments has the box of its move points.
Bounds bounds(const Path& path);

}  // namespace edaha
