// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "base/keyed_random.h"
#include "geometry/path.h"

namespace edaha {

// Millimetres, y up, the trunk's foot at the origin; headings in radians from straight up,
// positive to the right.
struct Branch {
    Vec2 end;
    double heading_rad = 0;
    double energy = 0;
    Key key = 0;               // of the choices from the root, whatever the seed
    std::int32_t parent = -1;  // index of a branch before this one
    std::uint16_t order = 0;   // how often the way here left the child of most energy
    std::uint8_t child = 0;    // which of its fork's children: type A 0 1, type B main right left
    bool terminal = false;     // bears a leaf: its energy was spent, or its children all dropped
};

// A branch that its destination's density kept from growing.
struct DroppedBranch {
    std::int32_t parent = 0;
    double energy = 0;
};

// Parents stand before their children. Branch 0 is the trunk's first.
struct Skeleton {
    std::vector<Branch> branches;
    std::vector<DroppedBranch> dropped;

    Vec2 start(const Branch& branch) const {
        return branch.parent < 0 ? Vec2(0, 0)
                                 : branches[static_cast<std::size_t>(branch.parent)].end;
    }
};

}  // namespace edaha
