// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>
#include <string>

#include "base/keyed_random.h"
#include "drawing/drawing.h"
#include "drawing/palette.h"
#include "drawing/site.h"
#include "geometry/bounds.h"
#include "ornament/ornament_params.h"

namespace edaha {

// Three tones of one colour and the one of what stands behind.
struct Tones {
    Colour light, mid, shade, back;
};

struct PlacementParams {
    OrnamentParams ornament;
    Tones tones;
    std::function<std::string(std::int32_t)> clump_id;  // of Site::clump
    std::string label;         // of the layer in front: "Leaves"; the one behind: "Leaves behind"
    std::uint32_t symbol = 0;  // index into Drawing::symbols; drawn growing to -y, 10 units long
    bool stroked = false;      // the symbol has strokes that take the tone's colour, too
    std::uint32_t salt = 0;    // leaves and blossom draw different numbers at one site
};

// Ornaments by layer. The layer's paint is the middle tone; it holds a group a clump, and that one
// a group a tone: shade, middle, light, so that the lit leaves lie on top.
struct Placement {
    Layer behind, front;
    std::vector<Affine> all;  // page_from_symbol of each
};

// Sets ornaments on sites: fans at twigs' ends, single ones along the twigs, alternating [E].
// Tones follow the light from the upper left over each clump and over the whole crown, with some
// chance, so that leaves make lit clouds. Which tone, size and angle one has depends on its site's
// key alone: another shape or size of leaf reshuffles nothing. O(ornaments).
Placement place(std::span<const Site> sites, const PlacementParams& params,
                const KeyedRandom& random);

}  // namespace edaha
