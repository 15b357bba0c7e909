// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "drawing/drawing.h"

namespace edaha {

// What a drawing is made of. `nodes` are the path nodes that the file holds: those of symbols count
// once, however often they are used.
struct DrawingCounts {
    std::size_t layers = 0;
    std::size_t groups = 0;
    std::size_t symbols = 0;
    std::size_t shapes = 0;  // outside symbols
    std::size_t uses = 0;
    std::size_t nodes = 0;
};

DrawingCounts count(const Drawing& drawing);

}  // namespace edaha
