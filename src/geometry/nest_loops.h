// SPDX-License-Identifier: MIT
#pragma once
#include "geometry/planar_map.h"

namespace edaha {

// For each loop of negative or no area, in the given order, the loop that borders the same face
// next below its smallest node, or kNone for the unbounded face. Needs a map's nodes, edges and
// loops (with `first`), not its faces. Expected O(E + loops * sqrt(E)).
std::vector<std::uint32_t> loops_below(const PlanarMap& map,
                                       std::span<const std::uint32_t> hole_loops);

}  // namespace edaha
