// SPDX-License-Identifier: MIT
#include "app/dress.h"

#include <algorithm>

namespace edaha {

std::vector<Dress> dresses(const Style& style) {
    const Palette& p = style.palette;
    return {{style.leaf, {p.leaf_light, p.leaf, p.leaf_shade, p.leaf_back}, "Leaves", 0},
            {style.blossom,
             {p.blossom_light, p.blossom, p.blossom_shade, p.blossom_back},
             "Blossom",
             1},
            {style.fruit, {p.fruit_light, p.fruit, p.fruit_shade, p.fruit_back}, "Fruit", 2}};
}

bool has_strokes(const std::vector<Shape>& shapes) {
    return std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) {
        return shape.paint.stroke.kind == Ink::Kind::inherit;
    });
}

}  // namespace edaha
