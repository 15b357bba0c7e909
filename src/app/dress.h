// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "drawing/drawing.h"
#include "ornament/placement.h"
#include "style/style.h"

namespace edaha {

// One kind of ornament of a style, with its tones and the salt of its random numbers.
struct Dress {
    const OrnamentParams& params;
    Tones tones;
    const char* label;
    std::uint32_t salt;
};

// Leaves, blossom and fruit. The style outlives them.
std::vector<Dress> dresses(const Style& style);

// Whether a drawing has strokes that take the tone's colour.
bool has_strokes(const std::vector<Shape>& shapes);

}  // namespace edaha
