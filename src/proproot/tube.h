// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "mesh/mesh.h"

namespace edaha {

// A circle of a tube: square to `normal`, of length 1, which points to the next one.
struct TubeCircle {
    Vec3 centre{0};
    Vec3 normal{0, 1, 0};
    double radius = 1;
    double along = 0;  // v
};

struct TubeParams {
    int points = 12;        // of a circle
    bool grounded = false;  // the last one is the tube's cut with the ground, an ellipse
    bool pointed = false;   // the last one is a point
    double round = 0;       // u goes from 0 to this
};

// Adds a part to the mesh: consecutive circles joined, both ends closed, outwards. Frames don't
// roll about the tube: double reflection (Wang et al. 2008), exact to fourth order in the spacing.
// At least two circles, no two of one centre. (u, v): round the tube, along it.
void add_tube(Mesh& mesh, MeshPart part, std::span<const TubeCircle> circles,
              const TubeParams& params);

}  // namespace edaha
