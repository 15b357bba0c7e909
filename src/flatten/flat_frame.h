// SPDX-License-Identifier: MIT
#pragma once
#include "geometry/path.h"
#include "mesh/mesh.h"

namespace edaha {

// Where a flat drawing shows what, before it is put on a page: in mm, y down, the world's origin at
// (0, 0).
struct FlatFrame {
    double mm_per_unit = 1;  // at `middle`
    Vec3 right{1, 0, 0}, up{0, 1, 0}, to_eye{0, 0, 1};
    Vec3 middle{0};       // of the mesh
    double distance = 0;  // perspective: of the eye from there; 0: orthographic

    Vec2 flat_from_world(Vec3 point) const;
    double mm_per_unit_at(Vec3 point) const;
};

}  // namespace edaha
