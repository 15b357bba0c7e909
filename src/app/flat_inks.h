// SPDX-License-Identifier: MIT
#pragma once
#include "drawing/palette.h"
#include "flatten/flatten.h"

namespace edaha {

// The palette's colours for a mesh: materials "leaf", "blossom" and "fruit" take those, "xylem" (in
// a hollow) the darkest of the wood's, "obstacle" the fruit's, the palette's accent; what has a
// colour of its own that one, darker and lighter, and all else the wood's. Lines are the colour of
// bark marks.
FlattenInks flat_inks(const Palette& palette, const std::vector<Material>& materials);

// The middle one of a material's tones.
Colour middle_tone(const Palette& palette, const Material& material);

}  // namespace edaha
