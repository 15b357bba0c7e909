// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <numbers>

#include "base/range.h"

namespace edaha {

enum class PrismCut { longest, turn };      // the longest side (the paper) | the sides in turn [E]
enum class PrismFrame { paper, parallel };  // two rotations (5) | the least turn from the parent's
// The paper's | sides run back to the parent's top | prisms stand on it and lean, without any step.
enum class PrismJoint { open, mitre, weld };
enum class FoliageShape { none, balls, tiers, sprays };

// Closed, faceted masses of leaves in place of single ones [E].
struct FoliageParams {
    // Balls at the ends; tiers: cones round the trunk, one a prism; sprays: one along each branch,
    // and a cone at the trunk's end.
    FoliageShape shape = FoliageShape::none;
    double size_mm = 20;       // radius; sprays: half the width where they are widest
    double size_spread = 0.2;  // varies by up to this part of it
    double stretch = 1;        // height of balls in widths; others: in lengths of their bearers
    double flatness = 0.5;     // sprays: height in widths
    double upright = 0.5;      // balls: 0: the axis goes on as the branch, 1: straight up
    double roughness = 0.15;   // corners lie off by up to this part of the radius
    std::int64_t sides = 6;    // round the axis
    std::int64_t rings = 3;    // balls: of corners between the ends
    std::int64_t from = 2;     // depth of the first prism that bears one
};

// What a tree of prisms grows by. Defaults are those of Uehara & Takai, "A modelling method for
// three-dimensional tree-like models" [P], as far as the paper states one; the rest is ours [E].
// Lengths in mm of the model.
struct PrismParams {
    double length_mm = 60;       // L, length of the trunk's first prism (3)
    std::int64_t depth = 6;      // N of the last prisms; the trunk's first has 1 (3)
    double length_power = 1;     // a prism of depth N has length L / N^power: 1 in the paper
    double length_spread = 0;    // length varies by up to this part of it (8)
    double side_length = 1;      // mixed: length of side branches, and all they bear [E]
    double radius_mm = 6;        // of the circle through the first triangle's corners
    double radius_spread = 0;    // 0: equilateral; 1: corners anywhere in their thirds [E]
    double side_a_mm = 0;        // instead of the radius: the first triangle's three sides
    double side_b_mm = 0;        //
    double side_c_mm = 0;        //
    double taper = 1;            // width of a prism's top, in widths of its base [E]
    double side_thickness = 1;   // mixed: width of side branches, in widths of their half [E]
    std::int64_t halvings = 60;  // so many on the way from the foot; then straight on only [E]
    bool pointed = false;        // the last prisms are pyramids [E]
    std::int64_t bole = 0;       // so many prisms of the trunk go straight first [E]
    double straight = 1;         // weights of the three cases (6.1)
    double two_way = 1;          // (6.2)
    double mixed = 1;            // (6.3)
    double both = 1.0 / 3;       // mixed: share of forks with both halves beside the main (6.3)
    Range alpha{0, 1};           // 0: straight on, 1: square to the parent (6.2)
    Range beta{0, 1};            // of the other half (6.2)
    PrismCut cut = PrismCut::longest;
    double cut_spread = 0;    // the cut lies up to half of this part of a side off its middle (8)
    double wander_rad = 0;    // every direction is off by up to this [E]
    double lift = 0;          // directions are drawn up by this, or down if below 0 [E]
    Range heading_rad{0, 0};  // of the first triangle, round the trunk [E]
    PrismFrame frame = PrismFrame::paper;
    PrismJoint joint = PrismJoint::open;
    bool interference = false;  // no prism passes through one that stands (8)
    std::int64_t tries = 4;     // so many other directions are tried before it is dropped [E]
    double turn_rad = std::numbers::pi / 6;  // off the first by up to this [E]
    double ground_mm = 0;       // with interference: nothing ends lower; 0: even below ground [E]
    double site_mm = 4;         // size of the places for twigs [E]
    double along_mm = 0;        // their spacing along thin prisms; 0: at ends only [E]
    double along_width_mm = 2;  // thin: the square root of the base's area is below this [E]
    std::int64_t limit = 200'000;  // more prisms are refused
    FoliageParams foliage;
};

}  // namespace edaha
