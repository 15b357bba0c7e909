// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/keyed_random.h"
#include "prism/frame.h"
#include "prism/section.h"

namespace edaha {

// Corners 0-2 of the base and 3-5 of the top above them; both counter-clockwise seen from the tip.
// Convex, with flat sides (but see welded_corners()). A pyramid's top corners are one point.
using PrismCorners = std::array<Vec3, 6>;

// One branch of the paper: where it stands and what it grew from. In mm; y up.
struct Prism {
    Key key = 0;
    std::int32_t parent = -1;  // before its children in the list
    std::uint16_t depth = 1;   // N: the trunk's first has 1
    std::uint8_t child = 0;    // 0: straight on, 1 and 2: on either half
    std::uint16_t order = 0;   // halvings on the way from the foot
    bool last = true;          // nothing grows from it
    Mat3 frame{1};             // world from branch
    Vec3 origin{0};            // m: centroid of the base, before a mitre
    double length = 0;         // |g|
    double top = 1;            // width of the top, in widths of the base
    Section base;
    PrismCorners corners{};

    Vec3 direction() const { return frame[1]; }
    Vec3 tip() const { return origin + length * frame[1]; }  // m + g, the top's centroid
};

// The corners as the paper has them: the base in the branch's xz plane, the top moved by the
// length.
PrismCorners open_corners(const Prism& prism);

// The same, but sides whose base lies above the parent's top run back to it, so that nothing gapes
// where the prism leans; by no more than the base is wide, however far that is [E].
PrismCorners mitred_corners(const Prism& prism, const Prism& parent);

// The same, but the base stays in the parent's top: there is no step at all, and sides are bent a
// little. Prisms shorter than wide may be turned inside out at a sharp turn [E].
PrismCorners welded_corners(const Prism& prism, const Prism& parent);

}  // namespace edaha
