// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "flatten/smooth_line.h"

namespace edaha {

// What happens to one end of a piece that is moved.
enum class GrownEnd : std::uint8_t {
    open,   // goes on into the neighbour's moved end: they meet where both moved lines do
    butt,   // goes straight back to the piece's own end
    taper,  // is not moved: the piece comes back to it
};

// A piece of a closed ring and how far it is moved to its right (outwards, where the ring's inside
// is on its left; below 0: inwards). What is not moved has open ends.
struct GrownPiece {
    CurvePiece piece;
    double by = 0;
    GrownEnd start = GrownEnd::open, end = GrownEnd::open;
};

// The ring with some of its pieces moved along their normals: their ends are, and arms grow with
// the chord, exact for lines and near for arcs. Pieces that aren't moved stay what they are, bit by
// bit, unless both they and a neighbour go on into each other. Closed, without gaps.
std::vector<CurvePiece> grow_ring(std::span<const GrownPiece> ring);

}  // namespace edaha
