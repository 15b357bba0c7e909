// SPDX-License-Identifier: MIT
#pragma once
#include "energy/limbs.h"

namespace edaha {

// Where a tree is set.
struct LimbsPlace {
    Vec2 foot_mm{0};      // on the page
    double turn_rad = 0;  // about the foot, from straight up, positive to the right
    double scale = 1;     // of lengths and widths
};

Limbs moved_limbs(Limbs limbs, const LimbsPlace& place);

}  // namespace edaha
