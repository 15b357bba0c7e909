// SPDX-License-Identifier: MIT
#pragma once
#include "drawing/drawing.h"

namespace edaha {

// How much of a tree hides another part of it: 1 - area(union of limbs and leaves) / sum of their
// areas. Limbs and leaves are those of a drawing in look "solid", each a shape or instance of its
// own; background, ground and what is drawn on bark do not count. 0 for a drawing without any.
// Our measure for the flatness that Mama & Nakajima asked people about (3.2).
//   Both areas are counted on one grid, of which some thirty thousand samples lie in the tree: what
// hides nothing counts in both alike, and the ratio is right to 0.005. The same on any machine.
// Cost: a few nanoseconds a sample, some hundred a leaf or a node of a limb's outline: 0.6 ms for a
// cherry of 2000 shapes.
double overlap_ratio(const Drawing& drawing);

}  // namespace edaha
