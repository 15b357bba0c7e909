// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "app/pipeline.h"

namespace edaha {

inline constexpr std::int64_t kMostFrames = 1000;

// The growth of a surface in so many pictures, evenly spaced over its steps; the last shows the
// grown tree. All have one page, scale and foot, so that they lie over each other; water and mound
// are those of the last, the shadow grows. Holds all pictures at once. 1 <= count <= steps, and the
// style grows by surface.
std::vector<Picture> draw_frames(const Style& style, const DrawingLoader& load, std::int64_t count,
                                 SurfaceWatch watch);

// "grow.svg", 7 of 12: "grow-007.svg". Three digits, or as many as `count` has.
std::string frame_file(const std::string& file, std::size_t number, std::size_t count);

}  // namespace edaha
