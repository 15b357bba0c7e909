// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

#include <glm/geometric.hpp>

#include "geometry/bounds.h"

namespace edaha {

// What ornaments of one clump, or all of a crown, are lit as: an ellipse, from the upper left [E].
struct Cloud {
    Vec2 centre{0}, half{1};

    Cloud() = default;
    explicit Cloud(const Bounds& box)
        : centre(box.centre()),
          half(std::max(box.width() / 2, 1.0), std::max(box.height() / 2, 1.0)) {}

    // Where in the cloud's light a place is: -1 in its shade, 1 on its lit side.
    double light(Vec2 place) const {
        constexpr Vec2 towards_light{-0.5, -0.87};
        return std::clamp(glm::dot((place - centre) / half, towards_light), -1.0, 1.0);
    }
};

}  // namespace edaha
