// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "flatten/draw_flat.h"
#include "flatten/label_map.h"
#include "flatten/smooth_line.h"

namespace edaha {

struct BarkParams {
    double spacing_px = 5;         // between lines seen from straight before them
    double units_per_spacing = 1;  // the same in units of u
};

// A line over a surface, in pixels.
struct BarkStroke {
    std::vector<Vec2> points;
};

// Lines of constant u (along tubes: u runs round them) over the front triangles of a mesh with
// (u,v), in lengths of its unit, halfway between multiples of the spacing. Cut where something
// hides them, by rays a few pixels apart and by halving where that changes, and into dashes of
// random lengths, always the same for a part; left out where a surface is seen so obliquely that
// they would crowd. Parts of the material "leaf" have none. In the order of triangles. O(triangles
// + crossings).
std::vector<BarkStroke> trace_bark(const Scene& scene, const BarkParams& params);

// As a layer "Bark" of closed areas that thin out to points; as wide as creases.
Layer draw_bark(const Scene& scene, const FlattenParams& params, const FlattenInks& inks,
                const FlatPlace& place);

}  // namespace edaha
