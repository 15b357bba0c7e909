// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "drawing/bark_tile.h"
#include "drawing/drawing.h"
#include "flatten/flat_frame.h"
#include "flatten/flatten_params.h"
#include "mesh/mesh.h"

namespace edaha {

// Colours of a flat drawing. `tones` are a material's, dark to light, spread evenly over the bands.
struct FlattenInks {
    std::vector<std::vector<Colour>> tones;  // a material of the mesh
    Colour line{0x3a, 0x2e, 0x28};
    Colour hidden{0x8a, 0x96, 0xa8};
    Colour paper{0xfb, 0xf7, 0xee};
};

struct StepReport {
    std::string name;  // "project", "segments", "snap", "label" ...
    double seconds = 0;
    std::size_t count = 0;  // of what the step makes
    std::string unit;       // "segments", "faces"
};

struct Flattened {
    std::vector<Layer> layers;  // bottom first, in mm, y down; on_page() puts them on a page
    FlatFrame frame;
    std::vector<StepReport> steps;
};

// A mesh as closed fills by part and tone, and strokes for the contours, creases and borders that
// are seen: a planar map of all candidate segments, one ray a face, fills
// and lines from the labels. The same bytes with any number of threads. Open, crossing or inverted
// surfaces are drawn as they are seen. O(n log n + k) for k crossings in the picture.
// Needs a finite mesh (mend() in mesh_check.h). `inks.tones` has one entry a material.
// `bark` is what params.bark_tile names; empty: none.
Flattened flatten(const Mesh& mesh, const FlattenParams& params, const FlattenInks& inks,
                  const BarkTile& bark = {});

}  // namespace edaha
