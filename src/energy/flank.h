// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "energy/limb_curve.h"
#include "geometry/bezier.h"

namespace edaha {

// How far a drawn flank may be off, for a limb of this half width: a fifteenth of it,
// 0.008 to 0.05 mm: less than the eye sees on a fat limb, while a twig keeps to few cubics.
double flank_tolerance_mm(double half_width);

// The curve of constant `across` (1: right flank, 0: centre line, -1: left flank) from a place to
// the limb's tip, as few cubics, joined with one tangent. Each has the curve's tangents at its ends
// and passes through its middle; where it strays, it is halved. A tenth of the cost of fit_cubics,
// for half as many nodes again: a tree has a hundred thousand twigs. About 0.1 microseconds a
// sample, 5 to 9 samples a cubic.
std::vector<Cubic> fit_flank(const LimbCurve& curve, double across, LimbPlace from);

}  // namespace edaha
