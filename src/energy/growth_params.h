// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/range.h"

namespace edaha {

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

// What a tree grows by. Defaults are those of Mama & Nakajima, "Tree Drawing System for
// Illustration based on Energy Model" [P], where the paper states one; the rest is ours [E].
// Headings are radians from straight up, right is positive. Style files use degrees.
enum class TreeType { a, b };              // two children, no main branch | main and two laterals
enum class GrowthOrder { depth, energy };  // the paper's recursion | largest energy first [E]
enum class Deposit { ends, segment };      // density at the branch's end | along all of it [E]

struct GrowthParams {
    TreeType type = TreeType::a;
    double energy = 300;            // E
    double stop_energy = 1;         // e_stop [E]
    double length_mm = 4;           // length of a branch of energy 1, l0 [E]
    double length_power = 0.4;      // l(e) = l0 e^power [E]
    double width_mm = 0.4;          // thickness of a branch of energy 1, w0 [E]
    double width_power = 0.5;       // w(e) = w0 e^power: 0.5 is the pipe model [E]
    Range share{0.1, 0.9};          // type A: energy of one child; the other has the rest (2.2.1)
    Range main_share{0.5, 0.6};     // type B: energy of the main branch (2.2.1)
    Range lateral_split{0.5, 0.5};  // type B: the right lateral's part of what remains [E]
    GrowthOrder order = GrowthOrder::depth;
    Range bole{1, 1};      // length of the trunk's first branch, times l(E) [E]
    Range lean_rad{0, 0};  // heading of the trunk's first branch [E]
    std::int64_t max_branches = 4'000'000;
};

struct BranchParams {
    Range turn_rad{radians(-45), radians(45)};        // type A, either child (Table 1)
    Range main_turn_rad{0, 0};                        // type B, main branch (Table 1)
    Range right_turn_rad{radians(15), radians(60)};   // type B, right lateral (Table 1)
    Range left_turn_rad{radians(-60), radians(-15)};  // type B, left (Table 1, misprint mended)
    // Type A: how far a child's turn is lessened by its share of energy, so that the heavier of
    // two children goes on straighter. 0: not at all (the paper) [E].
    double balance = 0;
    // Type A: the second child turns to the side that the first did not [E].
    bool opposite = false;
};

struct SpaceParams {
    double cell_mm = 4;  // c
    int candidates = 1;  // k: 1 is the plain recursive tree
    double drop = 0;     // tau; 0: no branch dropping
    Deposit deposit = Deposit::ends;
    bool drop_leaf = true;    // a fork that lost all its children bears a leaf [E]
    double clearance_mm = 0;  // no branch ends lower above the ground; 0: even below it [E]
    // Habit: preferred heading by branch order (the last value holds for all above), away from
    // straight up to either side; its weight in a candidate's score, kappa [E].
    std::vector<double> habit_rad{0};
    double habit_weight = 0;
    // Gravity: how far the habit of the last twigs is turned to straight down; heavy limbs keep
    // theirs. The turn grows as (1 - sqrt(e / E))^2 [E].
    double weep = 0;
};

// Which tree of its kind. vary = 0: all members of a family are equal; 1: independent [E].
struct VariantParams {
    std::uint64_t seed = 1;
    std::uint64_t family = 1;
    double vary = 1;
};

struct EnergyParams {
    GrowthParams growth;
    BranchParams branch;
    SpaceParams space;
    VariantParams variant;
};

}  // namespace edaha
