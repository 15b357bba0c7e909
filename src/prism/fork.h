// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "prism/prism.h"
#include "prism/prism_params.h"

namespace edaha {

// What is to grow from the top of a prism: one, two or three of these.
struct Shoot {
    std::uint8_t child = 0;    // 0: straight on, 1 and 2: halves
    Section section;           // its base, centred
    Vec2 centre{0};            // of that on the parent's top, in the parent's frame
    Vec3 direction{0, 1, 0};   // of length 1, in the world
    double length_factor = 1;  // of its length and all that it bears
};

// Uehara & Takai 6: straight on, two-way, or a mixture of both, by the weights; the cut, alpha,
// beta and the mixture's sub-case are drawn too. With our additions in PrismParams.
std::vector<Shoot> shoots_of(const Prism& prism, const PrismParams& params,
                             const KeyedRandom& random);

// Another direction within params.turn_rad of the shoot's, one for each attempt from 1 on.
Vec3 turned(const Shoot& shoot, Key key, std::uint32_t attempt, const PrismParams& params,
            const KeyedRandom& random);

}  // namespace edaha
