// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "surface/solid_mesh.h"
#include "surface/surface_params.h"

namespace edaha {

// A body in space: an obstacle (section 8) or the region of a hollow (section 7).
class Solid {
  public:
    explicit Solid(const SolidParams& params);

    // Signed, below 0 inside; exact where it is below `enough`, elsewhere at least that. What is
    // further from a mesh than is asked for costs next to nothing.
    double distance(const Vec3& p, double enough = std::numeric_limits<double>::infinity()) const;
    bool contains(const Vec3& p) const { return distance(p, 0) < 0; }
    // Of length 1, away from the nearest point of the surface: the distance's gradient.
    Vec3 outward(const Vec3& p) const;
    std::int64_t step() const { return params_.step; }

  private:
    SolidParams params_;
    std::vector<Vec3> corners_;  // of a wire
    std::shared_ptr<const SolidMesh> mesh_;
};

// The way of a wire: level, where the run from its first to its last corner is not.
std::vector<Vec3> wire_corners(const SolidParams& wire);

// The least distance to any of them that is there at `step`, as Solid::distance(); infinite without
// any.
double least_distance(std::span<const Solid> solids, std::int64_t step, const Vec3& p,
                      double enough = std::numeric_limits<double>::infinity());

// The tolerance is above 0.
struct DepthParams {
    std::int64_t step = 1;
    double least = 0;  // what is no deeper than that is not looked for
    double tolerance_mm = 0.1;
};

// How deep the deepest place of a triangle lies in them, too little by the tolerance at most; the
// least if none is deeper. O(1) if it is far from all of them.
double deepest(std::span<const Solid> solids, const std::array<Vec3, 3>& corners,
               const DepthParams& params);

// Whether it is deeper than the least. Where it is by no more than the tolerance, either answer.
bool is_deeper(std::span<const Solid> solids, const std::array<Vec3, 3>& corners,
               const DepthParams& params);

}  // namespace edaha
