// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

#include "base/stable_math.h"
#include "flatten/flatten_params.h"

namespace edaha {

// Where the light comes from, as seen: how far to the right, up and towards the eye. Unit.
inline glm::dvec3 seen_light(const FlattenParams& params) {
    const auto azimuth = stable::sin_cos(params.light_azimuth_rad);
    const auto elevation = stable::sin_cos(params.light_elevation_rad);
    return {azimuth.sin * elevation.cos, elevation.sin, azimuth.cos * elevation.cos};
}

}  // namespace edaha
