// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "surface/apex.h"

namespace edaha {

// Where a point lies about a branch.
struct WayPlace {
    double along = 0;   // mm of travel; beyond the ends by their directions
    double angle = 0;   // about the way, (-pi, pi]
    double radius = 0;  // mm from it
    Vec3 heading{0, 1, 0};
};

// The way an apex went, with a frame that doesn't roll about it (double reflection: Wang et al.
// 2008). An apex that has not moved has a way of length 0 along its heading.
class BranchWay {
  public:
    explicit BranchWay(const Apex& apex);

    // Against the nearest point of the way. O(steps).
    WayPlace place(const Vec3& point) const;

  private:
    std::vector<Vec3> points_;
    std::vector<double> travels_;
    std::vector<Vec3> headings_, sides_;  // of the stretch that begins at a point
};

}  // namespace edaha
