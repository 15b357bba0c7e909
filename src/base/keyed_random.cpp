// SPDX-License-Identifier: MIT
#include "base/keyed_random.h"

#include <cmath>

#include "base/stable_math.h"

namespace edaha {
namespace {

// The middle of one of 2^53 equal parts of (0, 1): never 0 or 1.
double unit(Key bits) {
    return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
}

}  // namespace

KeyedRandom::KeyedRandom(std::uint64_t family, std::uint64_t member, double vary)
    : family_(mix(family ^ 0x66616d696c79)),  // two salts: family 7 and member 7 differ
      member_(mix(member ^ 0x6d656d626572)),
      vary_(vary),
      rest_(std::sqrt(1 - vary * vary)) {}

double KeyedRandom::uniform(Key key, std::uint32_t purpose, std::uint32_t index) const {
    const Key place = key ^ mix((static_cast<Key>(purpose) << 32 | index) + 0x9e3779b97f4a7c15);
    if (vary_ >= 1) return unit(mix(place + member_));
    if (vary_ <= 0) return unit(mix(place + family_));
    return blended(place);
}

double KeyedRandom::blended(Key place) const {
    const double family = stable::normal_quantile(unit(mix(place + family_)));
    const double member = stable::normal_quantile(unit(mix(place + member_)));
    const double u = stable::normal_cdf(rest_ * family + vary_ * member);
    return std::fmin(std::fmax(u, 0x1p-54), 1 - 0x1p-53);
}

}  // namespace edaha
