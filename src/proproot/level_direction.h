// SPDX-License-Identifier: MIT
#pragma once
#include "base/stable_math.h"
#include "mesh/mesh.h"

namespace edaha {

// The level direction of an azimuth: 0 is +x, growing clockwise as seen from above, as the thesis
// counts angles (fig. 3.8).
inline Vec3 level_direction(double azimuth_rad) {
    const auto [sine, cosine] = stable::sin_cos(azimuth_rad);
    return {cosine, 0, sine};
}

}  // namespace edaha
