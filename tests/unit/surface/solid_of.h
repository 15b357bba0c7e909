// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "mesh/mesh.h"
#include "surface/surface_params.h"

namespace edaha {

inline SolidParams solid_of(SolidShape shape, const Vec3& from, const Vec3& to, double radius) {
    SolidParams params;
    params.shape = shape;
    params.from = from;
    params.to = to;
    params.radius_mm = radius;
    return params;
}

inline SolidParams solid_of(const Mesh& mesh, const Vec3& from) {
    SolidParams params = solid_of(SolidShape::mesh, from, {}, 0);
    params.mesh = std::make_shared<const Mesh>(mesh);
    return params;
}

}  // namespace edaha
