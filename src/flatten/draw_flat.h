// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "flatten/clock.h"
#include "flatten/flatten.h"
#include "flatten/labelled_map.h"

namespace edaha {

// Where the map lies on the page. The map's y points down, too.
struct FlatPlace {
    Vec2 origin_mm{0};  // of the map's origin
    double mm_per_px = 0.2;
};

// A labelled map as layers, bottom first: "Fills" (a group a part, see fills.h), "Lines" (a group a
// kind, see strokes.h); which of them, FlattenParams::look says. `parts` are the mesh's; with the
// map's labels they give names, materials. `clock` is told of each step.
// The same bytes with any number of threads.
std::vector<Layer> draw_flat(LabelledMap map, std::span<const MeshPart> parts,
                             const FlattenParams& params, const FlattenInks& inks,
                             const FlatPlace& place, StepClock& clock);

}  // namespace edaha
