// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "drawing/drawing.h"
#include "geometry/bounds.h"

namespace edaha {

// A leaf, blossom or fruit to hang on a twig: the stem at the origin, growing towards -y (y down),
// kLeafLength units long. Its shapes keep the contract of drawing.h, and each says both its inks:
// a colour, none, or inherit, which is the palette's leaf colour. So an instance sets its fill and
// its stroke to that colour.
struct Leaf {
    std::string name;  // the file's, without folder and ending
    std::vector<Shape> shapes;
    Bounds box;  // strokes included
};

inline constexpr double kLeafLength = 10;

struct LeafImport {
    Leaf leaf;
    std::vector<Problem> warnings;  // what of the drawing is not kept, by name and place
};

// Reads SVG as drawn by hand or by Inkscape, Illustrator and Figma (UTF-8, or Latin-1 that says
// so).
//   - Stem: the middle of what has the id "stem", which is not drawn; else the bottom centre of the
//     outlines' bounds. If it lies in their upper half (a hanging fruit), the drawing is turned
//     round, so that -y always leads away from it. Length is the height of the outlines.
//   - Colours: a shape without a class (on it or the groups around it), or whose class has the word
//     "recolour", is filled in the leaf colour; its stroke keeps its colour, unless the fill is
//     none: then the stroke takes the leaf colour. Others keep both. currentColor is the leaf
//     colour.
//   - A shape that is both filled and stroked becomes two where one path can't do: it is
//     open, or the stroke lies below. Strokes get round caps and joins, whatever the drawing says.
//   - Group opacity is multiplied into the shapes'.
// Throws InputError with every error, each with its place. Limits: svg_document.h.
LeafImport read_leaf(std::string_view svg_text, const std::string& file);

}  // namespace edaha
