// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace edaha {

// Points of a crown gathered into clumps, which are shaded as one rounded mass each.
struct Clumps {
    std::vector<std::uint32_t> of_point;
    std::vector<glm::dvec3> middles;
    std::vector<double>
        radii;  // root mean square distance of its points, times sqrt(5/3): a full ball's own
};

// As few clumps as leave no point farther than about `radius` from a middle: each first middle is
// the point farthest from those before it, then all move to the middles of their points a few times
// (Lloyd's algorithm) [E]. Ties go to the lower index. O(points x clumps).
Clumps find_clumps(std::span<const glm::dvec3> points, double radius);

}  // namespace edaha
