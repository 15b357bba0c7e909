// SPDX-License-Identifier: MIT
#include "prism/frame.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace edaha {

Mat3 paper_frame(Vec3 g) {
    const Vec3 d = glm::normalize(g);
    const double cos_theta = std::sqrt(d.x * d.x + d.y * d.y), sin_theta = d.z;
    const double sin_phi = cos_theta > 0 ? d.x / cos_theta : 0;
    const double cos_phi = cos_theta > 0 ? d.y / cos_theta : 1;
    return {Vec3(cos_phi, -sin_phi, 0), d,
            Vec3(-sin_theta * sin_phi, -sin_theta * cos_phi, cos_theta)};
}

Mat3 parallel_frame(const Mat3& from, Vec3 g) {
    const Vec3 d = glm::normalize(g), y = from[1];
    const Vec3 axis = glm::cross(y, d);  // its length is the angle's sine
    const double cosine = glm::dot(y, d);
    // Straight back there are many: half a turn about the branch's own x axis.
    if (cosine < -1 + 1e-12) return {from[0], d, glm::cross(from[0], d)};
    const auto turned = [&](Vec3 v) {  // Rodrigues' formula
        return cosine * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1 + cosine));
    };
    const Vec3 x = glm::normalize(turned(from[0]) - d * glm::dot(turned(from[0]), d));
    return {x, d, glm::cross(x, d)};
}

}  // namespace edaha
