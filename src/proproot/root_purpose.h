// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace edaha {

// One number for each kind of decision, apart from all other stages' (KeyedRandom).
enum RootPurpose : std::uint32_t {
    kLean = 300,
    kBow,
    kAzimuth,
    kHeight,
    kRung,
    kSag,
    kBulges,
    kRise,
    kForks,
    kPlace,
    kTurn,
    kSide,
    kYoung,
    kReach
};

}  // namespace edaha
