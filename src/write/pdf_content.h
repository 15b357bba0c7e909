// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>

#include "drawing/drawing.h"

namespace edaha {

// What a page shows. Its operators name layers /L0, /L1 … as properties, and graphics states by
// opacity: /f850 fills and /s600 strokes with 0.85 and 0.6.
struct PdfContent {
    std::string operators;
    std::set<std::string> states;
};

// The drawing's layers, each marked as optional content, in millimetres with the decimals of the
// SVG: the same geometry.
//   An instance is its map and then its symbol's operators, letter for letter the same every time:
// packed, that is as small as form XObjects would be, and editors, which put every form into a
// group with a clipping path of its own, get plain paths.
PdfContent pdf_content(const Drawing& drawing);

}  // namespace edaha
