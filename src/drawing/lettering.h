// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include "geometry/path.h"

namespace edaha {

// Words in a picture without a font: a hand of our own, of single strokes, to be drawn with a round
// pen. It looks the same on every machine and in every format, and a plotter can draw it. It has
// the letters a–z and A–Z, the digits, the blank and - _ . , : ; / % ° = + … – ( ) # ' × < > & ! ?
// Whatever else the text holds (UTF-8) becomes a small box.
struct LetteringParams {
    enum class Anchor { start, middle, end };
    double size_mm = 2;  // height of a capital; the pen adds its width. A line takes twice as much
    Anchor anchor = Anchor::start;
    Vec2 at{0, 0};  // on the base line
};

// Open subpaths of lines and cubics, in reading order; empty for a text without ink.
Path lettering(std::string_view text, const LetteringParams& params);

// How far the pen gets, side bearings included: "ab" is as wide as "a" and "b" together.
double lettering_width_mm(std::string_view text, double size_mm);

// The pen that suits the size, for common captions: a ninth of the capitals' height.
double lettering_pen_mm(double size_mm);

}  // namespace edaha
