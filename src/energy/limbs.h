// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "energy/growth_params.h"
#include "energy/look_params.h"
#include "energy/skeleton.h"

namespace edaha {

// A point of a limb's centre line. Between two nodes, a chord of length c apart, the centre line is
// the cubic with the Hermite ends (position, c velocity). Coordinates are the page's: y down, the
// trunk's foot at the origin.
struct LimbNode {
    Vec2 position;
    Vec2 velocity;  // |velocity| is near 1
    double half_width = 0;
    double taper = 0;  // d half_width / d chord length, <= 0
    double chord = 0;  // to the next node of the limb
};

// The chain that follows the child of most energy at each fork; the trunk is limb 0, and parents
// stand before their children.
struct Limb {
    std::uint32_t first_node = 0, node_count = 0;
    std::int32_t parent = -1;       // limb that it leaves
    std::uint32_t parent_node = 0;  // there: index into Limbs::nodes
    std::uint32_t fork = 0;         // the how manieth fork of its parent, from 1
    std::uint16_t order = 0;        // limbs between it and the ground
    char side = 0;                  // at a fork of three: 'r' or 'l', 0 for the main branch
    bool terminal = false;          // bears a leaf at its end
    bool back = false;              // on a bough that stands behind the trunk
    std::int32_t bough = 0;         // the limb of order 1 that bears it; the trunk's is itself
    std::int32_t clump = 0;   // the last limb on the way here that is heavy enough to bear one
    std::int32_t branch = 0;  // its first branch in the skeleton
    Key key = 0;
    Key member_key = 0;  // the same, but another for each seed
};

struct Limbs {
    std::vector<LimbNode> nodes;
    std::vector<Limb> limbs;

    std::span<const LimbNode> nodes_of(const Limb& limb) const {
        return std::span(nodes).subspan(limb.first_node, limb.node_count);
    }
    // "trunk", "limb-3", "limb-3-2": by the forks from the ground up, so that it stays the same
    // when a parameter changes; at a fork of three, "l" or "r" says which lateral.
    std::string id(const Limb& limb) const;
    std::vector<std::string> ids() const;  // of all limbs, at a third of the cost
};

// Centre lines are C2 cubic splines through the forks, clamped at their start to a heading between
// the parent's and their own (LookParams::sweep), with one node of gnarl between forks. Half widths
// fall monotonically. With look.straight, velocities are those of the straight chords.
// O(branches). All ours [E]: the paper draws straight sticks.
Limbs make_limbs(const Skeleton& skeleton, const EnergyParams& energy, const LookParams& look);

}  // namespace edaha
