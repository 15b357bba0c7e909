// SPDX-License-Identifier: MIT
#include "style/parameter_rows.h"

namespace edaha {
namespace {

constexpr const char* kOurs = "Edaha";
// Whole numbers up to 2^53 - 1 survive JSON and the studio's number fields.
constexpr double kLargestSeed = 9007199254740991;

}  // namespace

std::vector<Parameter> growth_rows() {
    using P = GrowthParams;
    RowWriter rows(
        "growth", [](auto& s) -> auto& { return s.energy.growth; });
    // clang-format off
    rows.add(&P::type, {"type", {"A", "B"}, "paper 2",
        "two children at a fork, or a main branch and two laterals"});
    rows.add(&P::energy, {"energy", {1, 1e6}, "paper 2.1",
        "energy of the trunk: more makes a larger tree", {20, 320}});
    rows.add(&P::stop_energy, {"stop-energy", {0.01, 1e4}, "paper 2.1",
        "a branch of this energy or less bears a leaf", {0.5, 8}});
    rows.add(&P::length_mm, {"length", mm(0.01, 1000), kOurs,
        "length of a branch of energy 1", {2, 8}});
    rows.add(&P::length_power, {"length-power", {0, 2}, kOurs,
        "length grows with this power of the energy", {0.1, 0.6}});
    rows.add(&P::width_mm, {"width", mm(0.001, 100), kOurs,
        "thickness of a branch of energy 1", {0.15, 0.9}});
    rows.add(&P::width_power, {"width-power", {0, 2}, kOurs,
        "thickness grows with this power of the energy; 0.5 is the pipe model", {0.3, 0.7}});
    rows.add(&P::share, {"share", {0.01, 0.99}, "paper 2.2.1",
        "type A: part of the energy that one child gets", {0.1, 0.9}});
    rows.add(&P::main_share, {"main-share", {0.01, 0.99}, "paper 2.2.1",
        "type B: part of the energy that the main branch gets", {0.2, 0.9}});
    rows.add(&P::lateral_split, {"lateral-split", {0.01, 0.99}, kOurs,
        "type B: the right lateral's part of what remains", {0.1, 0.9}});
    rows.add(&P::order, {"order", {"depth", "energy"}, kOurs,
        "which branch grows next: the paper's recursion, or the one of most energy"});
    rows.add(&P::bole, {"bole", {0, 100}, kOurs,
        "length of the trunk below its first fork, in lengths of its energy", {0, 2}});
    rows.add(&P::lean_rad, {"lean", degrees(-90, 90), kOurs,
        "heading of the trunk, from straight up to the right", {-40, 40}});
    rows.add(&P::max_branches, {"max-branches", {1, 1e9}, kOurs,
        "a tree of more branches is refused"});
    // clang-format on
    return rows.take();
}

std::vector<Parameter> branch_rows() {
    using P = BranchParams;
    RowWriter rows(
        "branch", [](auto& s) -> auto& { return s.energy.branch; });
    // clang-format off
    rows.add(&P::turn_rad, {"turn", degrees(-180, 180), "paper table 1",
        "type A: how far a child turns from its parent", {-90, 90}});
    rows.add(&P::main_turn_rad, {"main-turn", degrees(-180, 180), "paper table 1",
        "type B: how far the main branch turns", {-60, 60}});
    rows.add(&P::right_turn_rad, {"right-turn", degrees(-180, 180), "paper table 1",
        "type B: how far the right lateral turns", {0, 100}});
    rows.add(&P::left_turn_rad, {"left-turn", degrees(-180, 180), "paper table 1, misprint mended",
        "type B: how far the left lateral turns", {-100, 0}});
    rows.add(&P::balance, {"balance", {0, 1}, kOurs,
        "type A: how much straighter the heavier of two children goes on"});
    rows.add(&P::opposite, {"opposite", kOurs, "type A: the second child turns to the other side"});
    // clang-format on
    return rows.take();
}

std::vector<Parameter> space_rows() {
    using P = SpaceParams;
    RowWriter rows(
        "space", [](auto& s) -> auto& { return s.energy.space; });
    // clang-format off
    rows.add(&P::cell_mm, {"cell", mm(0.1, 1000), "paper 2.3",
        "width of a cell of the density grid", {2, 32}});
    rows.add(&P::candidates, {"candidates", {1, 256}, "paper 2.3.1",
        "angles that a branch tries, to take the emptiest; 1: no competition for space", {1, 16}});
    rows.add(&P::drop, {"drop", {0, 1e6}, "paper 2.3.2",
        "a branch is not grown into a cell of this density; 0: all are grown", {0.1, 1.6}});
    rows.add(&P::deposit, {"deposit", {"ends", "segment"}, "paper 2.3; segment: Edaha",
        "where a branch leaves density: at its end, or along all of it"});
    rows.add(&P::drop_leaf, {"drop-leaf", kOurs, "a fork that lost all its children bears a leaf"});
    rows.add(&P::clearance_mm, {"clearance", mm(0, 1000), kOurs,
        "no branch ends lower above the ground; 0: not even above it", {0, 40}});
    rows.add(&P::habit_rad, {"habit", degrees(0, 180), kOurs,
        "preferred heading by branch order, from straight up to either side", {0, 120}});
    rows.add(&P::habit_weight, {"habit-weight", {0, 1e4}, kOurs,
        "weight of the habit in the choice of a heading", {0, 12}});
    rows.add(&P::weep, {"weep", {0, 1}, kOurs,
        "how far the habit of the thinnest twigs is turned to straight down"});
    // clang-format on
    return rows.take();
}

std::vector<Parameter> variant_rows() {
    using P = VariantParams;
    RowWriter rows(
        "variant", [](auto& s) -> auto& { return s.energy.variant; });
    // clang-format off
    rows.add(&P::seed, {"seed", {0, kLargestSeed}, kOurs, "which tree of its family", {1, 5}});
    rows.add(&P::family, {"family", {0, kLargestSeed}, kOurs, "which family of the style", {1, 5}});
    rows.add(&P::vary, {"vary", {0, 1}, kOurs,
        "how unlike the members of a family are; 0: all equal, 1: independent"});
    // clang-format on
    return rows.take();
}

}  // namespace edaha
