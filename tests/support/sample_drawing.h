// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "drawing/drawing.h"

namespace edaha::test {

// A small picture with one of everything that the contract allows: layers and nested groups, paint
// set above and below, holes, open strokes, translucent fills and strokes, symbols with their own
// and with the instance's colour, turned, mirrored and squeezed instances, swatches, metadata.
// 120 x 100 mm.
Drawing sample_drawing();

// `shapes` tapered limbs and `uses` leaves in a field of 300 x 300 mm: for measuring.
Drawing field_drawing(std::size_t shapes, std::size_t uses);

}  // namespace edaha::test
