// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace edaha::surface {

// What the room draws random numbers for (see KeyedRandom): one number a kind of decision.
enum Purpose : std::uint32_t { kRuleChoice = 500, kRuleNumber, kBurlPlace, kBurlSize, kSprig };

}  // namespace edaha::surface
