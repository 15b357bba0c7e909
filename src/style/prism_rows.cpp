// SPDX-License-Identifier: MIT
#include "style/parameter_rows.h"

namespace edaha {
namespace {

constexpr const char* kOurs = "Edaha";

}  // namespace

std::vector<Parameter> prism_rows() {
    using P = PrismParams;
    RowWriter rows(
        "prism", [](auto& s) -> auto& { return s.prism; });
    // clang-format off
    rows.add(&P::length_mm, {"length", mm(0.1, 10000), "paper 3",
        "length of the trunk's first prism", {20, 100}});
    rows.add(&P::depth, {"depth", {1, 1000}, "paper 3",
        "depth of the last prisms; the trunk's first has 1", {2, 8}});
    rows.add(&P::length_power, {"length-power", {0, 4}, "paper 3; other than 1: Edaha",
        "a prism's length falls with this power of its depth", {0, 2}});
    rows.add(&P::length_spread, {"length-spread", {0, 0.9}, "paper 8",
        "lengths vary by up to this part of themselves"});
    rows.add(&P::side_length, {"side-length", {0.01, 10}, kOurs,
        "mixed: length of side branches, and of all they bear", {0.3, 1.5}});
    rows.add(&P::radius_mm, {"radius", mm(0.01, 1000), "paper 3",
        "of the circle through the corners of the first triangle", {2, 16}});
    rows.add(&P::radius_spread, {"radius-spread", {0, 1}, kOurs,
        "0: the first triangle is equilateral; 1: its corners lie anywhere in their thirds"});
    rows.add(&P::side_a_mm, {"side-a", mm(0, 1000), kOurs,
        "first side of the first triangle, instead of its radius", {4, 16}});
    rows.add(&P::side_b_mm, {"side-b", mm(0, 1000), kOurs,
        "its second side", {8, 16}});
    rows.add(&P::side_c_mm, {"side-c", mm(0, 1000), kOurs,
        "its third side", {8, 16}});
    rows.add(&P::taper, {"taper", {0.05, 1}, kOurs,
        "width of a prism's top, in widths of its base", {0.6, 1}});
    rows.add(&P::side_thickness, {"side-thickness", {0.01, 1}, kOurs,
        "mixed: width of side branches, in widths of their half of the triangle", {0.2, 1}});
    rows.add(&P::halvings, {"halvings", {0, 1000}, kOurs,
        "so many forks on the way from the foot; from there straight on only", {0, 4}});
    rows.add(&P::pointed, {"pointed", kOurs, "the last prisms are pyramids"});
    rows.add(&P::bole, {"bole", {0, 1000}, kOurs,
        "so many prisms of the trunk go straight on first", {0, 4}});
    rows.add(&P::straight, {"straight", {0, 1000}, "paper 6.1",
        "weight of going straight on", {0, 4}});
    rows.add(&P::two_way, {"two-way", {0, 1000}, "paper 6.2",
        "weight of forking in two", {0, 4}});
    rows.add(&P::mixed, {"mixed", {0, 1000}, "paper 6.3",
        "weight of going straight on and forking too", {0, 4}});
    rows.add(&P::both, {"both", {0, 1}, "paper 6.3",
        "mixed: share of forks with both side branches instead of one"});
    rows.add(&P::alpha, {"alpha", {0, 1}, "paper 6.2",
        "how far one half turns: 0: straight on, 1: square to its parent"});
    rows.add(&P::beta, {"beta", {0, 1}, "paper 6.2", "how far the other half turns"});
    rows.add(&P::cut, {"cut", {"longest", "turn"}, "paper 6.2; turn: Edaha",
        "which side of the triangle is cut: the longest, or each in its turn"});
    rows.add(&P::cut_spread, {"cut-spread", {0, 0.9}, "paper 8",
        "the cut is off the middle of its side by up to half this part of it"});
    rows.add(&P::wander_rad, {"wander", degrees(0, 90), kOurs,
        "every direction is off by up to this", {0, 30}});
    rows.add(&P::lift, {"lift", {-1, 1}, kOurs,
        "how far directions are drawn up, or below 0 down", {-0.4, 0.4}});
    rows.add(&P::heading_rad, {"heading", degrees(-180, 180), kOurs,
        "turn of the first triangle round the trunk", {-60, 60}});
    rows.add(&P::frame, {"frame", {"paper", "parallel"}, "paper 5; parallel: Edaha",
        "how prisms are twisted: by two rotations, or as little as can be"});
    rows.add(&P::joint, {"joint", {"open", "mitre", "weld"}, "paper 6; others: Edaha",
        "where prisms turn: gaps, sides that run back to the parent, or no step at all"});
    rows.add(&P::interference, {"interference", "paper 8",
        "no prism passes through one that stands"});
    rows.add(&P::tries, {"tries", {0, 256}, kOurs,
        "interference: so many other directions are tried before a prism is dropped", {0, 8}});
    rows.add(&P::turn_rad, {"turn", degrees(0, 180), kOurs,
        "interference: other directions are off the first by up to this", {5, 60}});
    rows.add(&P::ground_mm, {"ground", mm(0, 1000), kOurs,
        "interference: nothing ends lower above the ground; 0: even below it", {0, 80}});
    rows.add(&P::site_mm, {"site", mm(0.01, 1000), kOurs,
        "size of the places for twigs", {1, 8}});
    rows.add(&P::along_mm, {"along", mm(0, 1000), kOurs,
        "spacing of places for twigs along thin prisms; 0: at the ends only", {2, 10}});
    rows.add(&P::along_width_mm, {"along-width", mm(0.01, 1000), kOurs,
        "prisms thinner than this bear twigs along them", {1, 6}});
    rows.add(&P::limit, {"limit", {1, 1e8}, kOurs, "a tree of more prisms is refused"});
    // clang-format on
    return rows.take();
}

std::vector<Parameter> foliage_rows() {
    using P = FoliageParams;
    RowWriter rows(
        "foliage", [](auto& s) -> auto& { return s.prism.foliage; });
    // clang-format off
    rows.add(&P::shape, {"shape", {"none", "balls", "tiers", "sprays"}, kOurs,
        "balls at the ends, cones round the trunk, or one body along each branch"});
    rows.add(&P::size_mm, {"size", mm(0.1, 1000), kOurs,
        "radius; of sprays half their width", {8, 40}});
    rows.add(&P::size_spread, {"size-spread", {0, 0.9}, kOurs,
        "sizes vary by up to this part of themselves"});
    rows.add(&P::stretch, {"stretch", {0.1, 10}, kOurs,
        "height of balls in widths; of tiers and sprays in lengths of what bears them", {0.5, 2}});
    rows.add(&P::flatness, {"flatness", {0.05, 2}, kOurs, "sprays: height in widths", {0.2, 1}});
    rows.add(&P::upright, {"upright", {0, 1}, kOurs,
        "balls: 0: they lean as their branches do, 1: they stand upright"});
    rows.add(&P::roughness, {"roughness", {0, 0.4}, kOurs,
        "corners are off by up to this part of the radius"});
    rows.add(&P::sides, {"sides", {3, 64}, kOurs, "corners round the axis", {3, 12}});
    rows.add(&P::rings, {"rings", {1, 64}, kOurs, "balls: rings of corners", {1, 5}});
    rows.add(&P::from, {"from", {1, 1000}, kOurs,
        "depth of the first prisms that bear any", {1, 5}});
    // clang-format on
    return rows.take();
}

}  // namespace edaha
