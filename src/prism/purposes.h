// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace edaha::prism {

// What the room draws random numbers for (see KeyedRandom): one number a kind of decision.
enum Purpose : std::uint32_t {
    kCase = 300,
    kBoth,
    kWhich,
    kAlpha,
    kBeta,
    kCut,
    kLength,
    kCorner,
    kHeading,
    kWander,
    kTurn,
    kSite,
    kFoliage
};

}  // namespace edaha::prism
