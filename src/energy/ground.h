// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "drawing/drawing.h"
#include "drawing/palette.h"
#include "energy/look_params.h"

namespace edaha {

// Where a root meets the ground.
struct Footing {
    Vec2 middle;
    double half_width_mm = 0;
};

// Where a tree stands.
struct Stand {
    Vec2 foot;  // middle of the trunk's foot, on the ground
    double foot_width_mm = 0;
    double crown_left_mm = 0;  // x of the crown's sides
    double crown_right_mm = 0;
    std::vector<Footing> roots;  // prop roots, if it stands on any
};

// The ground under a tree, as far as its roots reach and the look asks for: a soft shadow, a mound
// with one, or water with ripples round all that stands in it [E]. Empty for Ground::none.
Layer draw_ground(const Stand& stand, const LookParams& look, const Palette& palette);

}  // namespace edaha
