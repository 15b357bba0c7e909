// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/planar_map.h"

namespace edaha {

// What kind of line an edge of the picture is, the strongest first: of several in one place the
// first counts.
enum class LineKind : std::uint8_t {
    silhouette,    // against the background
    contour,       // where a surface turns away from the eye
    border,        // between parts or materials, or of an open surface
    crease,        // where facets meet at a sharp angle
    intersection,  // where surfaces pass through each other
    tone,          // between tones: never drawn
    none
};

// What is seen in a face of the map.
struct FaceLabel {
    std::uint32_t part = kNone;  // kNone: the background
    std::uint8_t tone = 0;       // band, 0 the darkest
    auto operator<=>(const FaceLabel&) const = default;
};

// The picture as a planar map: what is seen in each face, and which edges are lines. Made by
// label_map(), read by all that draws. Edges that are none and have one label on both sides
// mean nothing and are dissolved.
struct LabelledMap {
    PlanarMap map;
    std::vector<FaceLabel> labels;  // a face; face 0, outside of all, is background
    std::vector<float> depth;       // a face: of what is seen in it, growing away from the eye
    std::vector<LineKind> line;     // an edge: a line that is seen, or none
    std::vector<LineKind> hidden;   // an edge: a line that something hides, or none
    double steps_per_px = 2048;     // of the map's grid
};

}  // namespace edaha
