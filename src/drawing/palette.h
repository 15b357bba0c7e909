// SPDX-License-Identifier: MIT
#pragma once
#include "drawing/paint.h"

namespace edaha {

// The colours of a picture. "Back" is for what stands behind: nearer to the paper.
struct Palette {
    Colour paper{0xfb, 0xf7, 0xee};
    Colour wood{0x6b, 0x4f, 0x43};
    Colour wood_light{0x82, 0x63, 0x54};  // twigs
    Colour wood_shade{0x57, 0x40, 0x38};  // the side away from the light
    Colour wood_back{0x9a, 0x80, 0x72};
    Colour mark{0x4a, 0x36, 0x2e};
    Colour leaf_light{0x9c, 0xc0, 0x6a};
    Colour leaf{0x6f, 0xa3, 0x52};
    Colour leaf_shade{0x48, 0x83, 0x4d};
    Colour leaf_back{0x8f, 0xb0, 0x8a};
    Colour blossom_light{0xff, 0xe9, 0xef};
    Colour blossom{0xf8, 0xc9, 0xd6};
    Colour blossom_shade{0xec, 0xa3, 0xb8};
    Colour blossom_back{0xf0, 0xd3, 0xd8};
    Colour fruit_light{0xf0, 0x7a, 0x5a};
    Colour fruit{0xd9, 0x48, 0x3b};
    Colour fruit_shade{0xb0, 0x2f, 0x35};
    Colour fruit_back{0xc9, 0x7a, 0x70};
    Colour ground{0xd9, 0xd4, 0xb8};
    Colour ground_shade{0xc3, 0xbd, 0x9d};
    // Leaf drawings keep no colours of their own, but take the nearest of these: for prints in few
    // inks. Black and white, which shade and light a leaf, become the darkest of the wood and the
    // paper.
    bool strict = false;
};

// Between two colours, `part` of the way from the first, channel by channel.
Colour mixed(Colour from, Colour to, double part);

// The palette's colour that is nearest to one, by distance in RGB.
Colour nearest(const Palette& palette, Colour colour);

}  // namespace edaha
