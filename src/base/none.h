// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace edaha {

// The index of nothing, in lists of up to 2^32 - 1 items.
inline constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace edaha
