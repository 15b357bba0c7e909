// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "energy/limb_curve.h"

namespace edaha {

// The curve that leads from a parent's flank to its child's.
struct Fillet {
    CurveSample parent;   // on the parent's flank, a hair inside; tangents run to the child
    CurveSample child;    // on the child's flank
    Vec2 corner;          // where the flanks cross
    LimbPlace place;      // of `child` on the child
    double along_mm = 0;  // of `parent`, from the joint along the parent
};

// Where a limb comes out of its parent. A child may run within its parent for a while, and on
// either side; one that stays inside for two thirds of its length has no joint to show.
class Joint {
  public:
    // The curves outlive the joint. `radius_mm`: how far fillets reach along either flank.
    Joint(const LimbCurve& child, const LimbCurve& parent, std::size_t parent_node,
          double radius_mm);

    // Side of the parent (+1 right, -1 left) on which the child comes out.
    int side() const { return side_; }

    // `flank`: the child's side; `ahead`: on the parent's far side of the joint (the crotch).
    std::optional<Fillet> fillet(int flank, bool ahead) const;

  private:
    // Where a point lies in the parent's section through it: to the right of the centre line.
    struct Offset {
        Vec2 point;
        double along_mm;  // the parent, from the joint
        double right_mm, half_width;
        Vec2 tangent;  // of the parent there
        // How far outside the parent's flank on one side; negative inside.
        double beyond(double side) const { return side * right_mm - half_width; }
    };
    struct Step {
        double along_mm;  // the child
        LimbSlice child;
        Offset centre;
    };
    // A place along the child, and where its flank is there.
    struct Crossing {
        double along_mm;
        Offset corner;
    };

    void find_side();
    Offset offset_at_joint() const;
    bool near_joint(Vec2 point) const;
    double parent_distance(const Offset& offset) const;
    Offset offset_of(Vec2 point, const Offset& beside) const;
    Crossing crossing(int flank, double along_mm, const Offset& beside) const;
    bool surely_inside(const Step& step, int flank) const;
    std::size_t last_inside(int flank) const;
    std::optional<Crossing> way_out(int flank) const;
    Crossing between(int flank, Crossing inside, Crossing outside) const;

    const LimbCurve& child_;
    const LimbCurve& parent_;
    std::size_t node_;
    double radius_mm_;
    LimbSlice frame_;       // the parent's at the joint
    double length_mm_ = 0;  // of the child
    double limit_ = 0;      // how far along the child a joint is looked for
    double stride_ = 0;
    int side_ = 1;
    // The first strides, as far as the side was looked for: both flanks' ways out start from them.
    std::array<Step, 16> steps_;
    std::size_t seen_ = 0;
};

}  // namespace edaha
