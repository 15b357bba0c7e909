// SPDX-License-Identifier: MIT
#include "proproot/prop_roots.h"

#include <algorithm>
#include <cmath>

#include "proproot/level_direction.h"

namespace edaha {

double tip_length(const PropRoot& root) {
    return std::min(kTipLength * root.radius, 0.4 * root.length);
}

Vec3 PropRoot::at(double along) const {
    const double x = curve.at_length(along);
    Vec3 place = base + level_direction(azimuth_rad) * x;
    place.y = curve.height(x);
    return place;
}

double PropRoot::radius_at(double along, double knob) const {
    // A tenth more at its end (3.4).
    double result = radius * (1 + 0.1 * along / length);
    if (trunk_radius > 0) {
        const double t = std::max(along, 0.0) / (kKnobLength * radius);
        if (t < 5) result *= 1 + knob * stable::exp(-t * t);
    }
    if (young) {
        const double t = 1 - (length - along) / tip_length(*this);
        if (t > 0) result *= std::sqrt(std::max(1 - t * t, 0.0));
    }
    return result;
}

std::string PropRoots::name_of(const PropRoot& root) const {
    const std::string stem =
        root.parent < 0 ? "root" : name_of(roots[static_cast<std::size_t>(root.parent)]);
    return stem + '-' + std::to_string(root.number);
}

}  // namespace edaha
