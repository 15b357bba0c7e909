// SPDX-License-Identifier: MIT
#include "prism/prism.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace edaha {

PrismCorners open_corners(const Prism& prism) {
    PrismCorners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 base = prism.base.corners[i];
        const Vec3 across = prism.frame[0] * base.x + prism.frame[2] * base.y;
        corners[i] = prism.origin + across;
        corners[i + 3] = prism.tip() + prism.top * across;
    }
    return corners;
}

PrismCorners welded_corners(const Prism& prism, const Prism& parent) {
    PrismCorners corners = open_corners(prism);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 base = prism.base.corners[i];
        corners[i] = prism.origin + parent.frame[0] * base.x + parent.frame[2] * base.y;
    }
    return corners;
}

PrismCorners mitred_corners(const Prism& prism, const Prism& parent) {
    PrismCorners corners = open_corners(prism);
    const Vec3 up = parent.direction();
    const double most = std::sqrt(area(prism.base));
    for (std::size_t i = 0; i < 3; ++i) {
        const double height = glm::dot(corners[i] - prism.origin, up);
        const Vec3 back = glm::normalize(corners[i] - corners[i + 3]);
        const double sinks = -glm::dot(back, up);
        if (height > 0) corners[i] += back * (sinks * most > height ? height / sinks : most);
    }
    return corners;
}

}  // namespace edaha
