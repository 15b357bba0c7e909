// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "flatten/arc_curves.h"
#include "flatten/flatten.h"
#include "flatten/labelled_map.h"
#include "flatten/seen_regions.h"

namespace edaha {

// What fills and strokes are drawn from: a map, its arcs, their curves, and where they lie.
struct FlatPicture {
    const LabelledMap& map;
    const SeenRegions& regions;
    const ArcGraph& graph;  // of kept_edges()
    const ArcCurves& curves;
    std::span<const MeshPart> parts;
    Affine page_from_px{1, 0, 0, 1, 0, 0};
    double mm_per_px = 1;
};

}  // namespace edaha
