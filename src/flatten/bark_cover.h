// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "drawing/bark_tile.h"
#include "flatten/view.h"

namespace edaha {

// Copies of a bark tile laid over the (u,v) of a mesh's parts.

// One stroke of one copy. `rank`: from 0 to 1, the first are drawn where there is room for few.
struct LaidLine {
    std::uint32_t line = 0;  // of the tile
    double rank = 0;
    std::vector<Vec2> places;  // in (u,v), one for each point of the tile's line
};

// The cover of a part. Nothing is laid where there is no (u,v) and on twigs too thin to show bark.
struct PartCover {
    double around = 0;   // the part's circumference in u, by which its seams jump; 0: has no seam
    Vec2 tile{1, 1};     // a tile's size in (u,v)
    Vec2 size{1, 1};     // lengths of the mesh's unit in a unit of u and of v
    double squeeze = 1;  // how much narrower a tile became so that a whole number goes round
    std::vector<LaidLine> lines;
};

// `units_per_mm`: of the tile, in lengths of the mesh's unit. As many tiles go round a part as come
// nearest to that. Copies are swayed by smooth noise that closes round the part, so that none is
// like the next. Parts narrower than `thinnest_units` and those of leaves and bare wood stay empty.
// By names of parts, not their order. O(triangles + strokes).
std::vector<PartCover> lay_bark(const Mesh& mesh, const View& view, const BarkTile& tile,
                                double units_per_mm, double thinnest_units);

}  // namespace edaha
