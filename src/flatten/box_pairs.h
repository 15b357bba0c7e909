// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace edaha {

struct ViewBox {
    std::array<float, 3> min, max;
};

// The pairs of boxes that overlap or touch, each once, the smaller index first, in no particular
// order. By Embree's collision of a bounding volume hierarchy with itself.
// Expected O(n log n + pairs). Errors: std::bad_alloc.
std::vector<std::array<std::uint32_t, 2>> overlapping_pairs(std::span<const ViewBox> boxes);

}  // namespace edaha
