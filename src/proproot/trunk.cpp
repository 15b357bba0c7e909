// SPDX-License-Identifier: MIT
#include "proproot/trunk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "proproot/level_direction.h"
#include "proproot/root_purpose.h"
#include "proproot/root_tables.h"

namespace edaha {
namespace {

constexpr double kPi = std::numbers::pi;
// Parts of the height, at a bend of 1 and 100 primaries.
constexpr double kMostLean = 0.2, kMostBow = 0.08;

}  // namespace

Vec3 Trunk::centre(double y) const {
    const double t = y / span;
    const double sine = stable::sin_cos(kPi * t).sin;
    return lean * (t * t) + bow * (sine * sine) + Vec3(0, y, 0);
}

Vec3 Trunk::direction(double y) const {
    const double t = y / span;
    const auto [sine, cosine] = stable::sin_cos(kPi * t);
    return glm::normalize((lean * (2 * t) + bow * (2 * kPi * sine * cosine)) / span +
                          Vec3(0, 1, 0));
}

double Trunk::radius(double y) const {
    return foot_radius * (1 - taper * std::min(y / span, 1.0));
}

Trunk make_trunk(const PropRootParams& params, int primaries, const KeyedRandom& random) {
    const Key key = name_key("trunk");
    const double age = primaries / 100.0;
    const auto anywhere = [&](std::uint32_t purpose) {
        return level_direction(2 * kPi * random.uniform(key, purpose));
    };
    Trunk trunk;
    trunk.foot_radius = trunk_radius(primaries);
    trunk.span = trunk.height = 1.2 * highest_primary(params, primaries);
    const double bend = params.trunk_bend * age * trunk.span;
    trunk.lean = anywhere(kLean) * (kMostLean * bend);
    trunk.bow = anywhere(kBow) * (kMostBow * bend);
    trunk.taper = params.trunk_taper * age;
    return trunk;
}

}  // namespace edaha
