// SPDX-License-Identifier: MIT
#pragma once
#include "geometry/bezier.h"
#include "geometry/path.h"

namespace edaha {

// What a straight way back to the start encloses, by Green's theorem, exact for cubics. Positive
// when the path turns from +x to +y: clockwise to the eye on a page, where y points down. Open
// subpaths count as if closed; areas wound twice count twice.
double signed_area(const Path& path);

// The curve's share of it: the area between the curve and the origin.
double swept_area(const Cubic& curve);

// Length of all drawn segments, closing lines included.
double length(const Path& path);

Path transformed(const Affine& target_from_source, const Path& path);

// The same shape run backwards; subpaths keep their order and closed ones their first point.
Path reversed(const Path& path);

}  // namespace edaha
