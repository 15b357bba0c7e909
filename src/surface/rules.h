// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>

#include "base/keyed_random.h"
#include "mesh/mesh.h"

namespace edaha {

// The parametric, stochastic L-system that drives apices (Mizoguchi & Miyata 5.1), in the notation
// of Prusinkiewicz & Lindenmayer. A line each, or several with ; between them:
//   size = 40                                     a constant
//   axiom: A(0)                                   what the first apex is
//   A(t) : t > 5 : 0.3 -> +(20) A(t + 1)          a production: condition and weight may be left
//   A(t) -> bud(50, 137.5 * t, 10)[B(0)] A(t + 1) out, a condition be *
// # begins a comment. What a successor may hold, and arithmetic: rule_words.h.
//
// At each step the apex's module is rewritten by a production of its name and number of values
// whose condition holds: the first such one without a weight, but if weighted ones come before it,
// one of these, chosen by their weights. Its orders are carried out from left to right; the module
// in it is what the apex is next. Without a production or a module the apex goes on as it is.
class Rules;

// A module with its values: "A(3, 0.5)".
struct Module {
    std::uint32_t symbol = 0;  // index into the rules' names
    std::vector<double> values;
};

// What drives one apex. `frame` has the columns heading, left, up of the turtle.
struct ApexState {
    glm::dmat3 frame{1};
    double speed_mm = 60;
    double thickening_mm = 3;
    std::optional<Module> module;  // what is rewritten at the next step; none: goes on as it is
    bool stopped = false;
    Key key = 0;              // of its place in the tree
    std::int64_t age = 0;     // steps since it sprouted
    std::uint32_t order = 0;  // of branching
    std::uint32_t buds = 0;   // made so far
};

// A bud that the apex leaves behind at this step.
struct Bud {
    Vec3 direction{0, 1, 0};
    std::int64_t delay = 0;  // steps until it sprouts
    ApexState state;         // once it has sprouted
};

// Throws InputError with every problem: production, line, column. `file` and `first_line` say
// where the text stands.
std::shared_ptr<const Rules> parse_rules(std::string_view text, const std::string& file,
                                         int first_line = 1);

// The apex of the axiom, heading up.
ApexState first_apex(const Rules& rules, double speed_mm, double thickening_mm);

// One step. Returns the buds, in their order. Throws InputError where a value is not finite.
std::vector<Bud> advance(const Rules& rules, ApexState& apex, const KeyedRandom& random,
                         std::int64_t step);

}  // namespace edaha
