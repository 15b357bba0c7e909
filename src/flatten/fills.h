// SPDX-License-Identifier: MIT
#pragma once
#include "flatten/flat_picture.h"

namespace edaha {

// The closed areas of a picture: a group a part, from far to near, named after the part; in it the
// whole part in its base tone, then areas of its other tones. Each area is one path with its
// holes. Where an area meets one that is painted later it runs on under that by
// FlattenParams::trap_mm, less under thin ones; and where no lines cover the seams, all but thin
// twigs lie on one shape, "underlay": so no background shows between them, however wide pixels are.
// The colour of most areas is the layer's. Parts further back turn to the paper's colour by
// FlattenParams::fade. Parallel over areas. O(arcs).
Layer draw_fills(const FlatPicture& picture, const FlattenParams& params, const FlattenInks& inks);

}  // namespace edaha
