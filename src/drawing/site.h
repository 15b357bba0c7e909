// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "base/keyed_random.h"
#include "geometry/path.h"

namespace edaha {

// A place on the wood where leaves, blossom or fruit may sit. Millimetres, y down.
struct Site {
    Vec2 position;
    Vec2 direction;  // unit: the way the twig points there
    Key key = 0;     // of the place, whatever the seed
    double wood_width_mm = 0;
    double along_mm = 0;     // distance from the tip, along the twig
    std::int32_t clump = 0;  // the limb whose twigs' leaves are shaded as one cloud
    bool terminal = false;   // the end of a twig
    bool back = false;       // on a bough behind the trunk
};

}  // namespace edaha
