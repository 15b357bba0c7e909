// SPDX-License-Identifier: MIT
#pragma once
#include "energy/growth_params.h"
#include "energy/skeleton.h"

namespace edaha {

// Grows a tree after Mama & Nakajima, "Tree Drawing System for Illustration based on Energy
// Model": energy shared out at each fork (2.1, 2.2.1), turns drawn from ranges (2.2.2, Table 1),
// competition for space on a density grid and branch dropping (2.3). At every fork the energies of
// the children, grown or dropped, add up to their parent's. No recursion: depth costs no stack.
// Cost: O(candidates) a branch (order `energy`: and a heap's logarithm).
// IoError when a limit would be passed.
Skeleton grow(const EnergyParams& params);

double branch_length_mm(const GrowthParams& params, double energy);
double branch_width_mm(const GrowthParams& params, double energy);

}  // namespace edaha
