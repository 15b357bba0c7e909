// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "geometry/path.h"
#include "ornament/report.h"
#include "ornament/svg_document.h"
#include "ornament/svg_style.h"

namespace edaha::svg {

// One drawn path, in the user units of the drawing's root.
struct SvgShape {
    Path path;
    SvgStyle style;  // its stroke_width is in the root's units, too
    Spot spot;
};

struct SvgPicture {
    std::vector<SvgShape> shapes;  // bottom first
    std::optional<Vec2> stem;      // centre of what has the id "stem"
};

// Everything that the drawing shows, with groups, transforms, <use> and styles resolved. Widths
// scale by a transform's mean (the root of its determinant). A part with an error is left out and
// reported; limits of svg_document.h that are passed throw InputError. View boxes matter only for
// symbols and nested <svg>, which are not clipped.
SvgPicture collect_shapes(const SvgDocument& document, Report& report);

}  // namespace edaha::svg
