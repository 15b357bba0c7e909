// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "drawing/bark_tile.h"

namespace edaha {

struct BarkImport {
    BarkTile tile;
    std::vector<Problem> warnings;
};

// Reads a bark tile from SVG, as read_leaf() does. The view box (or width and height) is the
// period, a unit of it a millimetre; what overruns an edge goes on at the other. Stroked paths
// without a fill are lines of that width, a line a subpath. Filled shapes are narrow ones, and
// become their middle line with the width that they have across it, from one tip to the other.
// Colours lighter than a middle grey make light lines. Those drawn first count most. Throws
// InputError: as read_leaf(), for a drawing without a size, and if nothing is drawn.
BarkImport read_bark(std::string_view svg_text, const std::string& file);

}  // namespace edaha
