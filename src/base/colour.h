// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace edaha {

// sRGB, 8 bits a channel.
struct Colour {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Colour&) const = default;
};

}  // namespace edaha
