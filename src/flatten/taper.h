// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "flatten/smooth_line.h"

namespace edaha {

struct TaperParams {
    double width_px = 1;               // in the middle
    double taper_px = 0;               // length over which it thins to nothing at both ends
    std::span<const double> widths{};  // evenly along the line, in parts of width_px; empty: 1
    double tolerance_px = 0.1;         // of both sides
};

// The outline of an open line that thins out to points, as a closed path on the page: both sides
// fitted within the tolerance, with the line's own corners. Lines shorter than two tapers are
// thinner in the middle. Empty for lines shorter than a tenth of a pixel.
Path tapered(std::span<const CurvePiece> line, const TaperParams& params,
             const Affine& page_from_px);

}  // namespace edaha
