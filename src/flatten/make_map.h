// SPDX-License-Identifier: MIT
#pragma once
#include "flatten/clock.h"
#include "flatten/labelled_map.h"
#include "flatten/rays.h"
#include "flatten/tones.h"
#include "flatten/view.h"

namespace edaha {

// Steps 1 to 5: from the mesh to the map of what is seen, and what later steps need of the way.
struct SeenMesh {
    View view;
    ToneField tones;
    RayScene rays;
    LabelledMap map;
};

// A planar map of all segments at which what is seen may change, snapped to the view's grid, with
// a label a face and a kind of line an edge. `clock` is told of each step. Errors: std::bad_alloc.
SeenMesh see_mesh(const Mesh& mesh, const FlattenParams& params, StepClock& clock);

}  // namespace edaha
