// SPDX-License-Identifier: MIT
#pragma once
#include <fstream>
#include <iterator>
#include <string>

#include "drawing/check.h"
#include "ornament/leaf.h"

namespace edaha {

inline std::string text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// What check() says of a drawing that uses the leaf as placement does; one line each.
inline std::string breaches(const Leaf& leaf) {
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = 1000;
    drawing.symbols.push_back({"leaf", leaf.shapes});
    Use use;
    use.page_from_symbol = Affine(1, 0, 0, 1, 500, 500);
    use.paint.fill = use.paint.stroke = Colour{0, 128, 0};
    drawing.layers.emplace_back().label = "Leaves";
    drawing.layers.back().children.emplace_back(use);
    std::string all;
    for (const std::string& breach : check(drawing))
        all += breach + '\n';
    return all;
}

// "leaf" for the palette's colour, "none" or "#rrggbb".
inline std::string ink_text(const Ink& ink) {
    if (ink.kind == Ink::Kind::inherit) return "leaf";
    if (ink.kind == Ink::Kind::none) return "none";
    std::string text = "#";
    for (const int channel : {ink.colour.r, ink.colour.g, ink.colour.b}) {
        text += "0123456789abcdef"[channel / 16];
        text += "0123456789abcdef"[channel % 16];
    }
    return text;
}

inline std::string inks(const Leaf& leaf) {
    std::string all;
    for (const Shape& shape : leaf.shapes) {
        all += (all.empty() ? "" : ", ") + ink_text(shape.paint.fill) + '/' +
               ink_text(shape.paint.stroke);
    }
    return all;
}

inline std::string lines(const std::vector<Problem>& problems) {
    std::string all;
    for (const Problem& problem : problems)
        all += to_string(problem) + '\n';
    return all;
}

}  // namespace edaha
