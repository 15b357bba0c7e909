// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "flatten/strokes.h"

namespace edaha {

// The strokes without short ones that lie within longer strokes' ink all the way: left-overs of
// the teeth of a mesh's contours, dashes beside a line.
// O(length of the strokes near short ones).
std::vector<ViewStroke> drop_covered(std::vector<ViewStroke> strokes, const FlattenParams& params,
                                     double mm_per_px);

}  // namespace edaha
