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

// What share of strokes there is room for where they lie `squeeze` and, as they are seen, `room`
// times as near to each other as the tile's, which lie `spacing_px` apart; above 1: for all.
double crowd_demand(double spacing_px, double squeeze, double room);

struct BarkCoverParams {
    double units_per_mm = 1;    // of the tile, in lengths of the mesh's unit
    double thinnest_units = 0;  // parts narrower than that stay empty
    double spacing_px = 1e9;    // of the tile's strokes, seen straight
};

// As many tiles go round a part as come nearest to their size. Copies are swayed by smooth noise
// that closes round the part, so that none is like the next. Parts of leaves and bare wood stay
// empty, and strokes are left out for which there is room nowhere. By names of parts, not their
// order. O(triangles + strokes).
std::vector<PartCover> lay_bark(const Mesh& mesh, const View& view, const BarkTile& tile,
                                const BarkCoverParams& params);

}  // namespace edaha
