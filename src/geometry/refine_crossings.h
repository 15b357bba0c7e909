// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "geometry/border_runs.h"

namespace edaha {

// The runs of one ring with their common ends moved from where the chords cross to where the
// curves do (Newton's method on both parameters), rounded to the grid. Ends whose curves have no
// crossing nearby, as where they only touch, stay where they are.
std::vector<BorderRun> refine_crossings(const Chords& chords, std::vector<BorderRun> runs,
                                        double tolerance);

}  // namespace edaha
