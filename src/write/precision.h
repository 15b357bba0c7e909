// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "drawing/drawing.h"

namespace edaha {

// How many decimals a picture of this size needs, 0 to kMostDecimals. At 1000 pixels along the
// longer side the last decimal is a tenth of a pixel at most and a hundredth at least: 200 mm take
// two decimals. One more would make the file a sixth larger and change no pixel.
int page_decimals(double width_mm, double height_mm);

// Decimals for numbers that are shown `scale` times as large: as fine on the page as `decimals`.
int decimals_at_scale(int decimals, double scale);

// What a symbol's numbers need to be as exact on the page as the page's own, for each symbol: by
// its largest instance.
struct SymbolPrecision {
    int points = 0;
    int matrices = 0;  // the linear part; the shift has the page's
};
std::vector<SymbolPrecision> symbol_precision(const Drawing& drawing, int page_decimals);

// How much the map enlarges lengths: at most (the longer axis, within a factor of 1.4), and on the
// average (the root of the area's growth), which is what a scaled stroke's width takes.
double largest_scale(const Affine& map);
double mean_scale(const Affine& map);

// The largest coordinate of a symbol: an error in an instance's matrix is that much larger on the
// page.
double extent(const Symbol& symbol);

}  // namespace edaha
