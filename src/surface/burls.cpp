// SPDX-License-Identifier: MIT
#include "surface/burls.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/keyed_random.h"

namespace edaha {
namespace {

Key cell_key(double x, double y, double z) {
    const auto whole = [](double c) { return static_cast<Key>(static_cast<std::int64_t>(c)); };
    return step(step(step(0, whole(x)), whole(y)), whole(z));
}

}  // namespace

double burl_gain(const Vec3& p, const BurlSphere& sphere) {
    const double off = glm::distance(p, sphere.centre);
    if (off >= sphere.radius) return 0;
    if (off <= sphere.core) return sphere.strength;
    return sphere.strength * (sphere.radius - off) / (sphere.radius - sphere.core);
}

// A sphere lies in up to eight cells; two cells of one key only cost time.
BurlField::BurlField(std::span<const BurlSphere> spheres) : spheres_(spheres) {
    for (const BurlSphere& sphere : spheres)
        cell_ = std::max(cell_, 2 * sphere.radius);
    for (std::uint32_t i = 0; i < spheres.size(); ++i) {
        const Vec3 low = glm::floor((spheres[i].centre - spheres[i].radius) / cell_);
        const Vec3 high = glm::floor((spheres[i].centre + spheres[i].radius) / cell_);
        for (double x = low.x; x <= high.x; ++x) {
            for (double y = low.y; y <= high.y; ++y) {
                for (double z = low.z; z <= high.z; ++z)
                    cells_[cell_key(x, y, z)].push_back(i);
            }
        }
    }
}

std::span<const std::uint32_t> BurlField::near(const Vec3& p) const {
    if (cells_.empty()) return {};
    const Vec3 at = glm::floor(p / cell_);
    const auto cell = cells_.find(cell_key(at.x, at.y, at.z));
    if (cell == cells_.end()) return {};
    return cell->second;
}

double BurlField::factor(const Vec3& p) const {
    double sum = 1;
    for (const std::uint32_t i : near(p))
        sum += burl_gain(p, spheres_[i]);
    return sum;
}

double BurlField::largest(const Vec3& p) const {
    double most = 0;
    for (const std::uint32_t i : near(p))
        most = std::max(most, burl_gain(p, spheres_[i]));
    return most;
}

}  // namespace edaha
