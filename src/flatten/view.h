// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/flatten_params.h"
#include "geometry/grid_point.h"
#include "mesh/edges.h"
#include "mesh/mesh.h"

namespace edaha {

// A point as the camera sees it, on a grid in all three directions: x to the right, y down, z away
// from the eye, in steps of 1 / kStepsPerPx pixels. Straight lines stay straight in perspective
// too: z is then a multiple of -1 / distance. Within +-2^23, exact as a float.
struct ViewPoint {
    std::int32_t x = 0, y = 0, z = 0;
    bool operator==(const ViewPoint&) const = default;
};

inline GridPoint on_screen(ViewPoint p) {
    return {p.x, p.y};
}

inline Vec3 to_vec3(ViewPoint p) {
    return {p.x, p.y, p.z};
}

inline constexpr int kStepsPerPx = 2048;
inline constexpr double kMostPixels = 8000;  // along the longer side: the grid's limit

// A mesh seen by a camera. Everything after this works on the view's integers alone, so facing,
// crossings and visibility agree with each other.
struct View {
    std::vector<ViewPoint> at;  // a point of the mesh
    std::vector<std::uint8_t>
        front;  // a triangle: 1 if it turns its outside to the eye; edge-on: 0
    std::vector<std::uint8_t> shown;  // a triangle: 1 if it may be seen, see find_shown()
    double steps_per_unit = 1;        // in the middle of the mesh
    Vec2 origin{0};                   // where the world's origin is seen, in steps
    Vec3 right{1, 0, 0}, up{0, 1, 0}, to_eye{0, 0, 1};
    Vec3 middle{0};       // of the mesh
    double distance = 0;  // perspective: of the eye from there
};

// The longer side of what is seen spans `resolution` pixels, its middle is the view's origin. In
// perspective the eye stands as far away as shows the whole mesh in the field of view.
// O(points). The mesh is finite and not empty.
// `shown` is left empty.
View project(const Mesh& mesh, const CameraParams& camera, double resolution);

// What may be seen: front triangles, and of parts that are open anywhere the inside too. O(edges).
std::vector<std::uint8_t> find_shown(const Mesh& mesh, std::span<const MeshEdge> edges,
                                     const View& view);

}  // namespace edaha
