// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "base/colour.h"

namespace edaha {

// A colour, none, or the parent's (SVG's inheritance).
struct Ink {
    enum class Kind : std::uint8_t { inherit, none, colour };
    Kind kind = Kind::inherit;
    Colour colour;

    Ink() = default;
    Ink(Colour c) : kind(Kind::colour), colour(c) {}  // NOLINT: a colour is an ink
    static Ink none() { return Ink(Kind::none); }
    bool operator==(const Ink&) const = default;

  private:
    explicit Ink(Kind k) : kind(k) {}
};

// Strokes have round caps and joins and scale with their transform. Inherited at the root: no
// fill, no stroke. Fill rule: non-zero. A width of 0 means the parent's.
// Dashes, and the gaps between them, are dash_mm long, before the round caps, and begin with a
// dash; 0: solid. Symbols and instances have none. They belong to the stroke's ink as its opacity
// does. An opacity, 0 to 1, belongs to its ink: who sets the ink sets the opacity with it; who
// inherits the ink inherits the opacity too, unless it names one below 1. Opacities replace, they
// never multiply.
struct Paint {
    Ink fill;
    Ink stroke;
    double stroke_width_mm = 0;
    double dash_mm = 0;
    float fill_opacity = 1;
    float stroke_opacity = 1;
    bool operator==(const Paint&) const = default;
};

// The lengths of a paint, on a page that is `scale` times as large.
inline void scale_pen(Paint& paint, double scale) {
    paint.stroke_width_mm *= scale;
    paint.dash_mm *= scale;
}

}  // namespace edaha
