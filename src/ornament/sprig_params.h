// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace edaha {

// Small trees that the energy model grows, on a mesh's places for twigs. All ours [E].
struct SprigParams {
    double energy = 0;          // of each; 0: none, and leaves sit on the places themselves
    std::int64_t variants = 6;  // so many are grown, each a symbol
    double size_spread = 0.25;  // sizes vary by up to this part of themselves
    double droop = 0.1;         // how far they turn to hang straight down: 0-1
    double clump = 1.5;         // radius of the clumps that they stand in: lengths of a sprig
    double rounding = 0.5;      // how far they turn away from the middle of their clump: 0-1
};

}  // namespace edaha
