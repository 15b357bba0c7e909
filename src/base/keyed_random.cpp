// SPDX-License-Identifier: MIT
#include "base/keyed_random.h"

#include <cmath>

#include "base/stable_math.h"

namespace edaha {
KeyedRandom::KeyedRandom(std::uint64_t family, std::uint64_t member, double vary)
    : family_(mix(family ^ 0x66616d696c79)),  // two salts: family 7 and member 7 differ
      member_(mix(member ^ 0x6d656d626572)),
      vary_(vary),
      rest_(std::sqrt(1 - vary * vary)) {}

double KeyedRandom::blended(Key salted_key) const {
    const double family = stable::normal_quantile(unit(mix(salted_key + family_)));
    const double member = stable::normal_quantile(unit(mix(salted_key + member_)));
    const double u = stable::normal_cdf(rest_ * family + vary_ * member);
    return std::fmin(std::fmax(u, 0x1p-54), 1 - 0x1p-53);
}

}  // namespace edaha
