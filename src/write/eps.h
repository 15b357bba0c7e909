// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "drawing/drawing.h"

namespace edaha {

struct EpsParams {
    Colour paper{255, 255, 255};  // what translucent inks are mixed with
};

// The drawing as an EPS file's bytes, with the SVG's decimals; symbols are procedures, written once
// a tone. PostScript has no translucency: such inks are mixed with the paper and drawn opaque, so
// what lies below them is hidden; in a symbol, those above its first filled shape are mixed with
// that one's. The bounding box is the page; there is no date.
std::string eps_bytes(const Drawing& drawing, const EpsParams& params);

// Metadata::recipe of an EPS file that we wrote; empty if there is none.
std::string eps_recipe(std::string_view eps);

}  // namespace edaha
