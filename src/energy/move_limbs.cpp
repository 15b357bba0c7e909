// SPDX-License-Identifier: MIT
#include "energy/move_limbs.h"

#include <utility>

#include "base/stable_math.h"

namespace edaha {

Limbs moved_limbs(Limbs limbs, Vec2 foot_mm, double turn_rad) {
    const auto [sine, cosine] = stable::sin_cos(turn_rad);
    const auto turned = [s = sine, c = cosine](Vec2 v) {
        return Vec2(c * v.x - s * v.y, s * v.x + c * v.y);
    };
    for (LimbNode& node : limbs.nodes) {
        node.position = foot_mm + turned(node.position);
        node.velocity = turned(node.velocity);
    }
    return limbs;
}

}  // namespace edaha
