// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/paint.h"
#include "geometry/path.h"

namespace edaha::svg {

// Values of SVG 1.1's attributes and properties. All throw SyntaxError (scan.h) with the place in
// the text. Spaces around are allowed. Linear.

// In user units (px of 1/96 inch, CSS 2.1, 4.3.2), or in percent of something.
struct SvgLength {
    double value = 0;
    bool percent = false;
};
SvgLength read_length(std::string_view text);

// A number, or a percentage as a part of 1; kept within 0 and 1.
double read_opacity(std::string_view text);

// "x,y x,y ...": an odd number of numbers is an error.
std::vector<Vec2> read_points(std::string_view text);

// min-x min-y width height; the size is positive.
struct ViewBox {
    Vec2 origin{0};
    Vec2 size{0};
};
ViewBox read_view_box(std::string_view text);

// A list of matrix, translate, scale, rotate, skewX and skewY (7.6), the last applied first.
Affine read_transform(std::string_view text);

struct SvgColour {
    Colour colour;
    double opacity = 1;
};

// #rgb #rgba #rrggbb #rrggbbaa rgb() rgba() and the names of named_colours.h. rgb() takes numbers
// 0-255 or percentages, with commas or without.
SvgColour read_colour(std::string_view text);

// What `fill` and `stroke` hold. `current` is currentColor, and context-fill and -stroke.
struct SvgPaint {
    enum class Kind { none, current, colour, reference };
    Kind kind = Kind::none;
    SvgColour colour;  // a reference's: the fallback, if it names one
    bool has_fallback = false;
    std::string reference;  // an id, of url(#id)
};
SvgPaint read_paint(std::string_view text);

// The id of "#id" or url(#id), with or without quotes; none for anything else.
std::optional<std::string> read_reference(std::string_view text);

}  // namespace edaha::svg
