// SPDX-License-Identifier: MIT
#pragma once
#include "base/keyed_random.h"
#include "mesh/mesh.h"
#include "proproot/prop_root_params.h"

namespace edaha {

// The trunk above the roots: its foot at the origin, y up. Sato's is a cylinder; ours bends and
// tapers with age [E]. `span` is the height over which it does, whatever roots are drawn.
struct Trunk {
    double foot_radius = 7;
    double height = 132;
    double span = 132;
    Vec3 lean{0};      // how far its middle is off the foot's at `span`, level
    Vec3 bow{0};       // how far off that half way up, level
    double taper = 0;  // part of foot_radius that is lost over `span`

    Vec3 centre(double y) const;
    Vec3 direction(double y) const;  // of length 1
    double radius(double y) const;
};

// `height` is left for the roots to say.
Trunk make_trunk(const PropRootParams& params, int primaries, const KeyedRandom& random);

}  // namespace edaha
