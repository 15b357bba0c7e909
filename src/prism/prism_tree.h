// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "base/keyed_random.h"
#include "mesh/mesh.h"
#include "prism/prism_params.h"

namespace edaha {

struct PrismCounts {
    std::size_t prisms = 0;
    std::vector<std::size_t> by_order;  // order 0 is the trunk's first prism, of depth 1
    std::size_t turned = 0;             // out of the way of others
    std::size_t dropped = 0;            // found no room
    std::size_t foliage = 0;            // masses of leaves
};

struct PrismTree {
    Mesh mesh;
    PrismCounts counts;
};

// A tree of prisms after Uehara & Takai, "A modelling method for three-dimensional tree-like
// models", with what they leave to the future (PrismParams). In mm, the trunk's foot in the origin,
// y up. Each prism is a closed part of material "wood", of order depth - 1, with its axis:
// "trunk-2" is the trunk's second, "branch-2a1" the first on half a of that, "branch-2a2" the next
// straight on. Sites for twigs stand at the ends and along thin prisms; masses of leaves are closed
// parts "leaves-2a1" of material "leaf" (named after the prism that bears them). Each decision is
// drawn by its place in the tree: see KeyedRandom. O(n), with interference O(n log n). IoError
// where params.limit would be passed, or the parameters make no triangle or no case.
PrismTree grow_prisms(const PrismParams& params, const KeyedRandom& random);

}  // namespace edaha
