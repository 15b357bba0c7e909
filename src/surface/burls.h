// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.h"

namespace edaha {

// Where cambium grows faster: fully within `core`, less and less up to `radius` (section 6.1).
struct BurlSphere {
    Vec3 centre{0};
    double radius = 300;    // R
    double core = 160;      // R'
    double strength = 0.5;  // k
};

// K: k within R', falling linearly to 0 at R: a knob, not a cone (Fig. 14).
double burl_gain(const Vec3& p, const BurlSphere& sphere);

// Spheres by cells as wide as the largest of them, to be asked for the sum of K at a place (eq. 6).
class BurlField {
  public:
    explicit BurlField(std::span<const BurlSphere> spheres);

    // 1 + sum of K, in the spheres' order. O(spheres nearby).
    double factor(const Vec3& p) const;
    // The largest K at a place, 0 without any. O(spheres nearby).
    double largest(const Vec3& p) const;

  private:
    std::span<const std::uint32_t> near(const Vec3& p) const;

    std::span<const BurlSphere> spheres_;
    double cell_ = 1;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;  // looked up only
};

}  // namespace edaha
