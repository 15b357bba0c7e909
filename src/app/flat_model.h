// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/model_mesh.h"
#include "drawing/site.h"
#include "energy/ground.h"
#include "energy/move_limbs.h"
#include "flatten/flatten.h"
#include "ornament/ornament_params.h"
#include "ornament/place_sprigs.h"

namespace edaha {

// The meshes of a style as seen: layers, and what stands on them and under them.
struct FlatModel {
    ModelMesh model;
    Flattened flat;
    Stand stand;
    LimbsPlace crown;  // where a crown goes on: on the trunk's end, its way, as wide
};

// `trunk_mm`: how thick the crown's trunk is; 0: there is none. The trunk of prop roots becomes as
// thick if the style does not say the scale, and is of one tone: the crown's shade begins above.
// `bark` is the tile that the style names.
FlatModel draw_model(const Style& style, ModelMesh model, double trunk_mm, const BarkTile& bark);

// The mesh's places for twigs, as seen. Clumps are parts: boughs of order 2 with all they bear.
std::vector<Site> sites(const FlatModel& model);

// The same for sprigs, with their depth.
std::vector<SprigPlace> sprig_places(const FlatModel& model);

// Makes ids of all shapes and groups XML names, and other than each other and than `taken`.
void settle_ids(std::vector<Layer>& layers, const std::vector<Layer>& taken,
                const std::vector<Symbol>& symbols);

}  // namespace edaha
