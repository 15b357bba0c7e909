// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/bark_cover.h"
#include "flatten/label_map.h"
#include "flatten/seen_stretches.h"

namespace edaha {

// The way of a laid line over one front triangle.
struct BarkPiece {
    std::uint32_t part = 0, line = 0;  // of the cover
    double start = 0, end = 0;         // along the line: whole numbers are its points
    SurfaceStep step;
    float room = 1;    // between neighbouring lines in the view, seen straight: 1
    float facing = 1;  // how straight it is seen, seen straight: 1
    float bright_from = 0, bright_to = 0;
};

// Pieces that follow each other.
using BarkWay = std::vector<BarkPiece>;

// All ways of all lines over front triangles, hidden or not, by part and line, and along it. A
// line goes on over seams of (u,v) by its places alone, so pieces join only where they meet
// in the view. `px_per_unit`: of the mesh, seen straight. O(triangles + pieces).
std::vector<BarkWay> cross_bark(const Scene& scene, std::span<const PartCover> covers,
                                double px_per_unit);

}  // namespace edaha
