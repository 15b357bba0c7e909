// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// How the wood of a skeleton is drawn. All of it is ours [E].
enum class Look { solid, silhouette, outline, line };
enum class Ground { none, shadow, mound, water };

struct LookParams {
    Look wood = Look::solid;
    bool straight = false;      // limbs as the paper's straight sticks
    double gnarl = 0.2;         // sideways wander of a limb between its forks, part of the length
    double sweep = 0.6;         // how far a child sets out along its parent before it turns: 0-1
    double fillet = 1;          // radius of a joint's fillets, in widths of the child
    double tip = 0.35;          // width of a limb's end, part of the width of its last branch
    double min_width_mm = 0.2;  // no twig is drawn thinner
    double root_flare = 0.8;    // how far the trunk widens at the ground, part of its width
    double root_height = 1.5;   // height of that flare, in widths of the trunk
    double stroke_mm = 0.25;    // look outline: stroke of the contour
    double back = 0.3;          // part of the boughs that stand behind the trunk
    double marks = 0;           // bark marks per 10 mm of limb (birch)
    double mark_min_width_mm = 3;  // limbs thinner than this bear none
    Ground ground = Ground::shadow;
    double ground_width = 0.6;  // of the crown's width
};

}  // namespace edaha
