// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "flatten/flat_picture.h"

namespace edaha {

// One line of the drawing: arcs in a row, of kinds that go together.
struct ViewStroke {
    std::vector<CurvePiece> pieces;  // in pixels
    LineKind kind = LineKind::none;  // the one of most of it
    bool closed = false;
    bool joined = false;  // an end of it lies on another line
};

// The lines that are seen (or those that are hidden) as few long strokes: at each node a line goes
// on where it turns least, first to its own kind, then to one like it (contours and silhouettes,
// creases and intersections). None turns back by more than 120 degrees. Then single straight
// pieces that were left over go on round corners, at the cost of longer strokes. Lines whose
// width is 0 are left out, as are strokes shorter than min_line_mm that don't connect others.
// O(arcs).
std::vector<ViewStroke> chain_strokes(const FlatPicture& picture, const FlattenParams& params,
                                      bool hidden);

// As a layer "Lines" with groups by kind, thin ones below. With FlattenParams::taper_mm open
// strokes become closed areas that thin out to points.
Layer draw_lines(const FlatPicture& picture, const FlattenParams& params, const FlattenInks& inks);

// Hidden lines as a layer of that name, thin and dashed.
Layer draw_hidden_lines(const FlatPicture& picture, const FlattenParams& params,
                        const FlattenInks& inks);

double width_mm(const FlattenParams& params, LineKind kind);

}  // namespace edaha
