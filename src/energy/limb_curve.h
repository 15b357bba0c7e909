// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "energy/limbs.h"
#include "geometry/fit_cubic.h"

namespace edaha {

// A place on a limb: span between two nodes, and t in [0, 1] within it.
struct LimbPlace {
    std::size_t span = 0;
    double t = 0;
};

// Where a limb is at one place, and how wide: all that finding joints takes, at half the cost of a
// section.
struct LimbSlice {
    Vec2 centre;
    Vec2 tangent;  // unit, towards the tip
    double half_width;

    // The side +1 is the right-hand one as the page is seen by someone who walks to the tip.
    Vec2 normal() const { return {-tangent.y, tangent.x}; }
    Vec2 at(double across) const { return centre + normal() * (half_width * across); }
};

// What a limb is at one place of its centre line.
struct LimbSection : LimbSlice {
    double taper;      // d half_width / d length, <= 0
    double curvature;  // of the centre line, positive when it turns to the section's +1 side

    // The curve of constant `across`: its direction there, or zero where it doubles back.
    CurveSample sample(double across) const;
};

// A limb's centre line and width as functions of place. `flare` widens the foot of a trunk:
// half widths grow by up to that part, over `flare_height_mm` [E].
class LimbCurve {
  public:
    explicit LimbCurve(std::span<const LimbNode> nodes) : nodes_(nodes) {}
    LimbCurve(std::span<const LimbNode> nodes, double flare, double flare_height_mm)
        : nodes_(nodes), flare_(flare), flare_height_mm_(flare_height_mm) {}

    LimbSection section(LimbPlace place) const;
    LimbSlice slice(LimbPlace place) const;  // of that section
    LimbSlice slice_at_node(std::size_t node) const;
    // The place `distance_mm` along the chords from a node; stops at either end of the limb.
    LimbPlace walk(std::size_t node, double distance_mm) const;
    double length_mm(std::size_t from_node, std::size_t to_node) const;
    std::size_t spans() const { return nodes_.size() - 1; }
    double chord_mm(std::size_t span) const { return nodes_[span].chord; }
    bool flared() const { return flare_ > 0; }

  private:
    struct Span;
    double flare_left(LimbPlace place) const;

    std::span<const LimbNode> nodes_;
    double flare_ = 0;
    double flare_height_mm_ = 1;
};

}  // namespace edaha
