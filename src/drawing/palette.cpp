// SPDX-License-Identifier: MIT
#include "drawing/palette.h"

#include <cmath>
#include <initializer_list>

namespace edaha {
namespace {

int squared_distance(Colour a, Colour b) {
    const int r = a.r - b.r, g = a.g - b.g, bl = a.b - b.b;
    return r * r + g * g + bl * bl;
}

}  // namespace

Colour mixed(Colour from, Colour to, double part) {
    const auto channel = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::floor(a + (b - a) * part + 0.5));
    };
    return {channel(from.r, to.r), channel(from.g, to.g), channel(from.b, to.b)};
}

Colour nearest(const Palette& p, Colour colour) {
    if (colour == Colour{0, 0, 0}) return p.wood_shade;
    if (colour == Colour{255, 255, 255}) return p.paper;
    Colour best = p.wood;
    for (const Colour one :
         {p.wood, p.wood_light, p.wood_shade, p.mark, p.leaf_light, p.leaf, p.leaf_shade,
          p.blossom_light, p.blossom, p.blossom_shade, p.fruit_light, p.fruit, p.fruit_shade}) {
        if (squared_distance(one, colour) < squared_distance(best, colour)) best = one;
    }
    return best;
}

}  // namespace edaha
