// SPDX-License-Identifier: MIT
#pragma once
#include "drawing/drawing.h"

namespace edaha {

// How much of a tree hides another part of it: 1 - area(union of limbs and leaves) / sum of their
// areas. Limbs and leaves are those of a drawing in look "solid", each a shape or instance of its
// own; background, ground and what is drawn on bark do not count. 0 for a drawing without any.
// Our measure for the flatness that Mama & Nakajima asked people about (3.2). Cost: that of
// area_of_union.
double overlap_ratio(const Drawing& drawing);

}  // namespace edaha
