// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "surface/rules.h"

namespace edaha {

// A growing tip, or what became of one. Branch b comes from apex b.
struct Apex {
    std::uint32_t vertex = 0;
    ApexState state;
    std::int32_t parent = -1;  // the branch it sprouted on
    std::uint32_t order = 0;   // of branching; the trunk has 0
    std::int64_t sprouts = 0;  // at this step: until then it is a bud
    bool grows = false;
    double travel = 0;            // mm so far
    std::vector<Vec3> path;       // where it was at each step, from its sprouting on
    std::vector<double> travels;  // and how far it had come
};

}  // namespace edaha
