// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "drawing/bark_tile.h"
#include "flatten/draw_flat.h"
#include "flatten/label_map.h"

namespace edaha {

// A stroke of bark as it is seen: pixels, at even distances.
struct TileStroke {
    std::uint32_t part = 0;
    bool light = false;
    std::vector<Vec2> points;
    std::vector<double> widths_px;
};

// The strokes of a bark tile over the front triangles of a mesh with (u,v), as its surface turns,
// shrinks and swells under them. Laid as bark_cover.h says, cut where something hides them; where
// they would crowd (seen obliquely, far away, on thin branches) only those of low rank stay; so
// shade is hatching: dark lines stand densest where it is dark, light ones where it is light. They
// thin out where they end. In the order of parts and of the tile. Empty without (u,v).
std::vector<TileStroke> trace_tile(const Scene& scene, const BarkTile& tile,
                                   const FlattenParams& params, const FlatPlace& place);

// As a layer "Bark" of closed areas in a group a part, "<part>-bark"; light ones below.
Layer draw_tile_bark(const std::vector<TileStroke>& strokes, const Mesh& mesh,
                     const FlattenParams& params, const FlattenInks& inks, const FlatPlace& place);

}  // namespace edaha
