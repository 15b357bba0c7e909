// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include "geometry/path.h"

namespace edaha {

// Reads SVG path data (SVG 1.1, 8.3: every command, absolute and relative, compact numbers,
// implicit repeats). Quadratic curves are raised, arcs become cubics (arc.h). What is drawn after a
// close begins with a move to the closed subpath's start. Nothing else is changed: segments of no
// length and lone moves stay. Empty text gives an empty path.
// Where SVG draws up to the first fault, this throws SyntaxError (scan.h). Linear.
Path read_path_data(std::string_view text);

}  // namespace edaha
