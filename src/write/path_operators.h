// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "geometry/path.h"

namespace edaha {

inline constexpr double kPointsPerMm = 72 / 25.4;

// Appends a path as PDF's construction operators (32000-1, 8.5.2): m, l, c, v, y and h. Every point
// is rounded to `decimals`, as in the SVG; what rounds to nothing is left out, as there
// (path_text.h). False, and nothing is appended, if all of it is.
bool append_path_operators(std::string& text, const Path& path, int decimals);

// "a b c d e f cm\n": the linear part with `fine` decimals, the shift with `coarse` ones.
void append_map_operator(std::string& text, const Affine& map, int fine, int coarse);

// "w w\n" and "[dash] 0 d\n", with one decimal more than places have: twigs are only a few steps
// wide. A dash that rounds to 0 is none.
void append_width_operator(std::string& text, double mm, int decimals);
void append_dash_operator(std::string& text, double mm, int decimals);

}  // namespace edaha
