// SPDX-License-Identifier: MIT
#include "drawing/inherit.h"

namespace edaha {
namespace {

void apply(std::optional<Colour>& ink, float& opacity, const Ink& own, float own_opacity) {
    const bool inherits = own.kind == Ink::Kind::inherit;
    if (!inherits || own_opacity != 1) opacity = own_opacity;
    if (own.kind == Ink::Kind::none) ink.reset();
    if (own.kind == Ink::Kind::colour) ink = own.colour;
}

}  // namespace

InheritedPaint inherit(const InheritedPaint& parent, const Paint& own) {
    InheritedPaint paint = parent;
    apply(paint.fill, paint.fill_opacity, own.fill, own.fill_opacity);
    apply(paint.stroke, paint.stroke_opacity, own.stroke, own.stroke_opacity);
    if (own.stroke.kind != Ink::Kind::inherit || own.dash_mm != 0) paint.dash_mm = own.dash_mm;
    if (own.stroke_width_mm != 0) paint.stroke_width_mm = own.stroke_width_mm;
    return paint;
}

}  // namespace edaha
