// SPDX-License-Identifier: MIT
#pragma once
#include "energy/limbs.h"

namespace edaha {

// A tree that stands elsewhere: its foot at `foot_mm` of the page, turned about it by `turn_rad`
// (from straight up, positive to the right). Widths and lengths stay.
Limbs moved_limbs(Limbs limbs, Vec2 foot_mm, double turn_rad);

}  // namespace edaha
