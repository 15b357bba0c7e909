// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "surface/surface_growth.h"

namespace edaha {

// A straight trunk without branches.
inline SurfaceParams trunk(std::int64_t steps) {
    SurfaceParams params;
    params.rules = "axiom: A\nA -> A\n";
    params.steps = steps;
    return params;
}

// All of its steps.
inline SurfaceGrowth grown(const SurfaceParams& params) {
    SurfaceGrowth growth(params, KeyedRandom(1, 1, 1));
    while (growth.steps() < params.steps)
        growth.step();
    return growth;
}

}  // namespace edaha
