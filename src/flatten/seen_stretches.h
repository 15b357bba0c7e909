// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/rays.h"

namespace edaha {

// A straight piece of a line over one triangle, in the view.
struct SurfaceStep {
    Vec3 from{0}, to{0};
    std::uint32_t triangle = 0;
};

// A place on a line: in the view, and how far along which step.
struct SeenPlace {
    Vec2 at{0};
    std::uint32_t step = 0;
    double t = 0;
};

using SeenStretch = std::vector<SeenPlace>;  // two places at least

// The stretches of a line over front triangles that nothing hides: by rays a few pixels apart, and
// halving where that changes. What hides less of the line than that may be missed.
std::vector<SeenStretch> seen_stretches(const RayScene& rays, std::span<const SurfaceStep> line);

}  // namespace edaha
