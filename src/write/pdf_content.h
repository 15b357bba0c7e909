// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "geometry/bounds.h"

namespace edaha {

// How instances of symbols are written.
//   paths: the map, then the symbol's operators, the same letters every time. Packed, they
//          are small, and editors, which put every form into a group with a clipping path, get
//          plain paths. But a page of many trees unpacks to a hundred megabytes and more.
//   forms: the map, then the symbol's form XObject (ISO 32000-1, 8.10). It is drawn in the state
//          that its caller has set, so one form serves all tones: shapes without a colour of their
//          own take the current one.
enum class PdfInstances { paths, forms };

// A stream's operators. They name graphics states by opacity: /f850 fills and /s600 strokes with
// 0.85 and 0.6.
struct PdfOperators {
    std::string text;
    std::set<std::string> states;
};

struct PdfForm {
    PdfOperators operators;
    Bounds box;  // with room for the pen
    int decimals = 0;
};

// What a page shows. Its operators name layers /L0, /L1 … as properties, and forms /F0, /F1 …
struct PdfContent {
    PdfOperators operators;
    std::vector<PdfForm> forms;
};

// The drawing's layers, each marked as optional content, in millimetres with the decimals of the
// SVG: the same geometry.
PdfContent pdf_content(const Drawing& drawing, PdfInstances instances);

}  // namespace edaha
