// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// A letter as a pen writes it, in units of a twentieth of a capital's height, y up, the base line
// at 0. Strokes are parted by `|` and are knots parted by blanks:
//   4,20      a knot: lines lead to it and from it;
//   4,20e     a knot the pen passes in a direction: n e s w, or @ and degrees from east, counted to
//             the north. Between two of these runs a cubic with these tangents (lettering.cpp);
//   *4,20     a dot.
struct Glyph {
    char32_t letter;
    double advance;
    const char* strokes;
};

// The letter's glyph, or an empty box.
const Glyph& glyph_of(char32_t letter);

}  // namespace edaha
