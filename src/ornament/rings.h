// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "geometry/path.h"

namespace edaha {

// Makes imported paths keep the contract of drawing.h.

// Segments of which all points lie within `shortest` of where they begin (in x and in y) are left
// out, and so are subpaths without any other; a closed one ends exactly where it began, without a
// line for that.
Path without_short_segments(const Path& path, double shortest);

// Every subpath closed.
Path closed(const Path& path);

bool is_closed(const Path& path);

struct FillRings {
    Path path;
    bool is_exact = true;  // the area is the path's own
};

// Closed rings that fill by the non-zero rule what `path` fills by its rule, outlines (positive
// area) before holes. Rings that cross neither themselves nor each other are turned by their
// nesting, and those that change nothing dropped. Where rings cross, or there are too many segments
// to tell (a million pairs), they stay as they are or are turned all together: inexact under the
// even-odd rule, or where a hole sticks out of its outlines.
FillRings fill_rings(const Path& path, bool even_odd);

}  // namespace edaha
