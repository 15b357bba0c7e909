// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "geometry/path.h"

namespace edaha {

// Appends a path as SVG 1.1 path data, short: each command relative or absolute, whichever is
// shorter, h, v and s where they say the same, letters and blanks left out where the grammar
// allows.
//
// Points are rounded to `decimals` first (number_text.h) and every offset is taken between rounded
// points, so that errors never add up: what a reader gets is each point rounded, no more.
// Segments that round to a point are left out, as are lines that only go back to where z goes, and
// subpaths of which nothing remains. About 20 ns a number.
void append_path_data(std::string& text, const Path& path, int decimals);

}  // namespace edaha
