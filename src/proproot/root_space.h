// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "proproot/root_line.h"

namespace edaha {

// Where a line stands among the roots. Two lines pass through each other if somewhere they are
// closer than the sum of their radii there, except near a joint: a child and its parent within the
// child's joint, two children of one parent where both are within theirs.
struct RootBody {
    std::int32_t self = -1;    // -1: the trunk
    std::int32_t parent = -2;  // -2: of the trunk
    double joint = 0;          // length of its line that counts as its joint
};

// How long a joint is: until roots that set out side by side can have parted.
double joint_length(double radius, double parent_radius);

// The roots that stand, for finding what a new one would pass through. Upright columns of square
// cells over the ground; O(length) to add or to ask where roots are not crowded.
class RootSpace {
  public:
    // About the width of a thick root and the gaps between them.
    explicit RootSpace(double cell) : cell_(cell) {}

    bool free(std::span<const LinePoint> line, const RootBody& body) const;
    void add(std::span<const LinePoint> line, const RootBody& body);

  private:
    struct Stretch {  // between two points of a line
        LinePoint from, to;
        RootBody body;
    };
    using Cell = std::uint64_t;

    template <typename Visit>
    bool any_cell(const Stretch& stretch, const Visit& visit) const;

    double cell_;
    std::vector<Stretch> stretches_;
    std::unordered_map<Cell, std::vector<std::uint32_t>> columns_;  // only looked up, never walked
};

}  // namespace edaha
