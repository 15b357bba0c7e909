// SPDX-License-Identifier: MIT
#pragma once
#include "energy/limbs.h"
#include "geometry/path.h"

namespace edaha {

// What is drawn on a limb's bark, inside its outline: closed, positively oriented areas.
struct Bark {
    Path shade;  // the side away from the light, which comes from the upper left
    Path marks;  // lenticels and scars that run in from a flank (LookParams::marks)
};

Bark draw_bark(const Limbs& limbs, const Limb& limb, const LookParams& look);

}  // namespace edaha
