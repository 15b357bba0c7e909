// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/keyed_random.h"
#include "proproot/catenary.h"
#include "proproot/prop_root_params.h"
#include "proproot/trunk.h"

namespace edaha {

// One root: a catenary that leaves the trunk's surface, or the middle line of its parent, in one
// upright plane. Right-handed, y up, the ground at y = 0.
struct PropRoot {
    std::uint32_t order = 1;   // primaries have 1
    std::int32_t parent = -1;  // index of a root before it; -1: the trunk
    std::uint32_t number = 1;  // among its parent's, those left out counted too, from 1
    Key key = 0;               // of the choices that led here, whatever the seed
    Vec3 base{0};              // its branching point; base.y is the catenary's b
    double parent_along = 0;   // length of the parent up to there; 0 on the trunk
    double azimuth_rad = 0;    // see level_direction()
    double turn_rad = 0;       // azimuth less the parent's; 0 for primaries
    Catenary curve;
    double length = 0;        // from the base to the ground, or to a young root's tip
    double radius = 1;        // at the base; a tenth more at the ground
    double trunk_radius = 0;  // of the trunk at its base; 0 where it leaves a root
    bool bulges = false;      // rises at first
    bool young = false;       // ends in the air

    Vec3 at(double along) const;
    double radius_at(double along, double knob) const;
};

struct PropRoots {
    int primaries = 0;  // x: what the tables were read with
    Trunk trunk;
    std::vector<PropRoot> roots;  // parents before children
    std::size_t removed = 0;      // left out because they would have passed through others
    std::size_t bulging = 0;
    std::vector<std::size_t> by_order;  // roots of order i + 1

    std::string name_of(const PropRoot& root) const;  // "root-12", "root-12-3"
};

// Grows roots as Sato's thesis says (3.3): primaries evenly round the trunk, children at random
// places of their parents while the height allows, directions and slopes by its tables. Order by
// order, and within an order in turn: a root that would pass through what stands is drawn anew, up
// to `tries` times, then left out with all that it would have borne (root_space.h) [E].
// The same params and numbers give the same bits. O(tries) a root. IoError for more than 20,000.
PropRoots grow_prop_roots(const PropRootParams& params, const KeyedRandom& random);

// What x becomes for the seedling's length and depth: 1-100.
int effective_primaries(const PropRootParams& params);

// Over which length of a primary its knob fades, in radii, and of a young root's tip.
inline constexpr double kKnobLength = 2.2, kTipLength = 4;
double tip_length(const PropRoot& root);

}  // namespace edaha
