// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/mesh.h"
#include "proproot/prop_roots.h"

namespace edaha {

// The trunk (part 0, "trunk") and the roots, each a closed tube and a part of its own, named after
// PropRoots::name_of, in their order there. y up, the ground at 0, 1 unit = 1 cm. (u, v) are
// lengths in that unit, so that marks of one size fit everywhere. Circles are square to the way
// from the one before to the next one; the last one lies on the ground (3.4). Materials "trunk" and
// "root"; with order_colours "root-order-1" to "-5", which have colours.
Mesh mesh_of(const PropRoots& roots, const PropRootParams& params);

// Where the trunk ends and a crown goes on.
struct TrunkTop {
    Vec3 position{0};
    Vec3 direction{0, 1, 0};  // of length 1
    double radius = 1;
};
TrunkTop trunk_top(const PropRoots& roots);

}  // namespace edaha
