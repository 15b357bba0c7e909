// SPDX-License-Identifier: MIT
#pragma once
#include "base/range.h"
#include "proproot/prop_root_params.h"

namespace edaha {

// What Sato's thesis gives for a plant with x primary roots (tables 3.1, 3.3, 3.4).
struct RootAge {
    int most_primaries;  // the row's last x
    double highest;      // of the primaries' heights
    int max_order;
    double branchings;   // mean of one root
    int max_branchings;  // most of one root
};
const RootAge& root_age(int primaries);  // 1-100

// No root leaves the trunk or another root below this height (3.3.2).
inline constexpr double kLowestBranching = 9;
// A root of order 2 or more leaves its parent between these parts of the height of the parent's
// own branching point (3.3.2).
inline constexpr Range kForkHeights{0.15, 0.80};
// A bulging root rises by at most this part of the height of its branching point (3.3.2).
inline constexpr double kMostBulge = 0.20;
inline constexpr int kTurnBins = 9;

// What the params say, but not below the lowest branching, or the table.
double highest_primary(const PropRootParams& params, int primaries);

Range sag(RootType type);                           // of the catenary's -a (3.3.2)
double bulge_share(RootType type);                  // table 3.2
double slope_factor(double turn_rad);               // table 3.5
double root_radius(int primaries, unsigned order);  // (3.7), a fifth thinner by order
double trunk_radius(int primaries);                 // (3.6)

}  // namespace edaha
