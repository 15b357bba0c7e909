// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "prism/prism.h"
#include "prism/prism_params.h"

namespace edaha {

struct GrownPrisms {
    std::vector<Prism> prisms;  // by depth: parents before their children
    std::size_t turned = 0;     // out of another's way
    std::size_t dropped = 0;    // there was none
};

// Uehara & Takai 3-6, depth by depth instead of by recursion: thick prisms stand before thin ones
// look for room. O(n), with interference O(n log n). IoError where the limit would be passed, or
// the parameters make no triangle or no case.
GrownPrisms grow(const PrismParams& params, const KeyedRandom& random);

}  // namespace edaha
