// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "flatten/flatten_params.h"
#include "flatten/view_segment.h"
#include "mesh/edges.h"

namespace edaha {

// Brightness over a mesh: the cosine between normal and light, a number at each triangle's corners
// and linear between them in the view. No corner lies on a threshold, so isolines are plain.
struct ToneField {
    std::vector<std::array<float, 3>> at;  // empty for looks without tones: one band
    std::vector<float> thresholds;         // ascending; a band lies between two of them
    bool flat = false;                     // one number a triangle

    std::uint8_t band(float brightness) const;
};

// Normals are averaged round a point over triangles that no crease parts, then with those of
// neighbouring points. FlatLook::facets takes each triangle's own, parts with an axis the direction
// away from that if asked. Linear in edges and triangles, times the rounds of smoothing.
ToneField make_tones(const Mesh& mesh, std::span<const MeshEdge> edges, const View& view,
                     const FlattenParams& params);

// Where brightness passes a threshold within front triangles; and, for flat facets, the edges
// between bands. Ends on a shared edge are the same for both its triangles.
std::vector<ViewSegment> tone_segments(const Mesh& mesh, std::span<const MeshEdge> edges,
                                       const View& view, const ToneField& field);

}  // namespace edaha
