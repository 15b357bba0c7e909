// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "base/range.h"

namespace edaha {

// One kind of ornament on the twigs: leaves, blossom or fruit. Angles in radians. All ours [E].
struct OrnamentParams {
    std::string shape;             // a drawing of leaves/ by name, or a path; empty: none
    double size_mm = 6;            // from the stem to the far end
    double size_spread = 0.3;      // sizes are size (1 +- spread)
    double count = 3;              // at a twig's end: mean number
    double fan_rad = 1.2;          // they fan out to either side of the twig by up to this
    double along_mm = 0;           // spacing of further ones along the twigs; 0: none
    double along_width_mm = 1;     // on wood thinner than this
    double along_angle_rad = 0.9;  // angle between such a one and its twig
    double scatter_mm = 0;         // distance from the twig that a cluster spreads over
    double droop = 0.2;            // how far they turn to hang straight down: 0-1
    double upright = 0;            // how far they turn to stand straight up: 0-1
    double share = 1;              // part of the sites that bear one
    double behind = 0.35;          // part of them that is drawn behind the wood
};

}  // namespace edaha
