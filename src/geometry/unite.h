// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "geometry/path.h"

namespace edaha {

// For paths in millimetres.
struct UniteParams {
    // Of the chords with which crossings are found, against their curves. Borders that run within
    // two tolerances of each other are taken for one, features smaller than one vanish.
    double tolerance = 0.002;
    // Ends of the result's segments lie on this grid; a power of two keeps them exact. Doubled
    // until the paths fit (2^28 steps from the origin).
    double grid = 1.0 / 4096;
    // Outlines and holes below this area are left out; so are holes narrower than the tolerance.
    double min_area = 1e-3;
};

// The union of the paths' insides as one path. Each path's inside is its own under the non-zero
// rule, subpaths closed. Curves stay curves: what comes from one source cubic is one sub-cubic of
// it (its ends moved to the grid), neighbours from one source are joined, straight lines in a row
// become one. Rings are closed, outlines first and positive (signed_area > 0: clockwise to the eye
// where y points down), holes negative; each starts in its smallest point (by x, then y) and no
// segment has zero length. The result does not depend on the order of the paths. Built on snap
// rounding: coincident, tangent and self-crossing input is as good as any other.
// Expected O((n + k) log(n + k)) for n chords that cross k times.
Path unite(std::span<const Path> closed, const UniteParams& params = {});

// Area of that union without making it: what the chords enclose, and what lies between them and
// their curves. In the paths' own units squared; the grid's step is about an eighth of the
// tolerance. About two microseconds a chord.
double area_of_union(std::span<const Path> closed, double tolerance);

}  // namespace edaha
