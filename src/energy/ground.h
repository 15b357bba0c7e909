// SPDX-License-Identifier: MIT
#pragma once
#include "drawing/drawing.h"
#include "drawing/palette.h"
#include "energy/look_params.h"

namespace edaha {

// Where a tree stands.
struct Stand {
    Vec2 foot;  // middle of the trunk's foot, on the ground
    double foot_width_mm = 0;
    double crown_left_mm = 0;  // x of the crown's sides
    double crown_right_mm = 0;
};

// The ground under a tree: a soft shadow, or a mound with one [E]. Empty for Ground::none.
Layer draw_ground(const Stand& stand, const LookParams& look, const Palette& palette);

}  // namespace edaha
