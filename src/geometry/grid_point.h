// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>

#include "geometry/path.h"

namespace edaha {

// A point of the integer grid on which planar maps are built. Coordinates stay within
// +-kGridLimit, so that cross and dot products of differences are exact in 64 bits.
struct GridPoint {
    std::int32_t x = 0, y = 0;
    auto operator<=>(const GridPoint&) const = default;  // by x, then y
};

inline constexpr std::int32_t kGridLimit = 1 << 28;

__extension__ typedef __int128 Int128;

struct GridSegment {
    GridPoint a, b;
};

struct GridBox {
    GridPoint min{kGridLimit, kGridLimit};
    GridPoint max{-kGridLimit, -kGridLimit};

    void include(GridPoint p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
};

struct GridVector {
    std::int64_t x = 0, y = 0;
};

inline GridVector operator-(GridPoint a, GridPoint b) {
    return {std::int64_t{a.x} - b.x, std::int64_t{a.y} - b.y};
}
inline std::int64_t cross(GridVector a, GridVector b) {
    return a.x * b.y - a.y * b.x;
}
inline std::int64_t dot(GridVector a, GridVector b) {
    return a.x * b.x + a.y * b.y;
}

// Positive if c lies to the left of a -> b where y points up.
inline std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
    return cross(b - a, c - a);
}

inline Vec2 to_vec(GridPoint p) {
    return {p.x, p.y};
}

}  // namespace edaha
