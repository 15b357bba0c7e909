// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "flatten/labelled_map.h"
#include "flatten/view.h"

namespace edaha {

// A straight piece of the view at which what is seen may change, with the triangle that it
// lies on. `other` is the second triangle of creases and intersections, else kNone.
struct ViewSegment {
    ViewPoint a, b;
    std::uint32_t triangle = 0;
    std::uint32_t other = kNone;
    LineKind kind = LineKind::none;
};

}  // namespace edaha
