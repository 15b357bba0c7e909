// SPDX-License-Identifier: MIT
#pragma once
#include "drawing/drawing.h"
#include "drawing/page_params.h"
#include "drawing/palette.h"
#include "geometry/bounds.h"

namespace edaha {

// The layers' content, anywhere in the plane, on a page of its own: scaled to PageParams::size_mm
// (0: as it is), moved to the margins, strokes included; with a layer "Background" first if the
// paper is to be painted. Empty layers are left out. Stroke widths and dashes scale too.
// O(content).
Drawing on_page(Drawing drawing, const PageParams& page, const Palette& palette);

// The same where the content counts as filling `box`, for pictures that share a page.
Drawing on_page(Drawing drawing, const Bounds& box, const PageParams& page, const Palette& palette);

}  // namespace edaha
