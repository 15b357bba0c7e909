// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "prism/prism.h"
#include "prism/prism_params.h"

namespace edaha {

// A closed mass of leaves, faceted; points counter-clockwise seen from outside.
struct FoliageMass {
    std::uint32_t bearer = 0;  // index of a prism
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
};

// The masses of a tree by their shape, in the order of their bearers. Drawn by each bearer's place
// in the tree, so that a change of the foliage moves no branch. O(masses * sides * rings).
std::vector<FoliageMass> foliage_of(const std::vector<Prism>& prisms, const FoliageParams& params,
                                    const KeyedRandom& random);

}  // namespace edaha
