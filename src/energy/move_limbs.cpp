// SPDX-License-Identifier: MIT
#include "energy/move_limbs.h"

#include <utility>

#include "base/stable_math.h"

namespace edaha {

Limbs moved_limbs(Limbs limbs, const LimbsPlace& place) {
    const auto [sine, cosine] = stable::sin_cos(place.turn_rad);
    const auto turned = [s = sine, c = cosine](Vec2 v) {
        return Vec2(c * v.x - s * v.y, s * v.x + c * v.y);
    };
    for (LimbNode& node : limbs.nodes) {
        node.position = place.foot_mm + turned(node.position) * place.scale;
        node.velocity = turned(node.velocity);
        node.half_width *= place.scale;
        node.chord *= place.scale;
    }
    return limbs;
}

}  // namespace edaha
