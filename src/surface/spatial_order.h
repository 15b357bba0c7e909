// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "surface/growing_mesh.h"

namespace edaha {

// The new number of each old vertex and face; kNone for free ones.
struct Renumbering {
    std::vector<std::uint32_t> vertex, face;
};

// Numbers all anew so that what is near in space is near in memory (section 9 [E]): vertices along
// a curve through cells of space (Morton order), faces by their first vertices; no places stay
// free. The surface is what it was. O(n log n).
Renumbering sort_in_space(GrowingMesh& mesh, double cell_mm);

}  // namespace edaha
