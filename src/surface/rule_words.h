// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace edaha {

// What an apex can be told, in the notation of Prusinkiewicz & Lindenmayer where they have a sign
// for it. Angles in degrees, lengths in mm.
enum class Order : std::uint8_t {
    left,
    right,
    down,
    up,
    roll_left,
    roll_right,
    turn_round,
    level,
    speed,
    thicken,
    tropism,
    bud,
    stop
};

struct OrderWord {
    Order order;
    std::string_view name;
    std::size_t least, most;  // values
    std::string_view help;
};

inline constexpr OrderWord kOrderWords[] = {
    {Order::left, "+", 0, 1, "turns left by degrees; by `angle` where nothing is said"},
    {Order::right, "-", 0, 1, "turns right"},
    {Order::down, "&", 0, 1, "pitches down"},
    {Order::up, "^", 0, 1, "pitches up"},
    {Order::roll_left, "\\", 0, 1, "rolls left round the heading"},
    {Order::roll_right, "/", 0, 1, "rolls right"},
    {Order::turn_round, "|", 0, 0, "turns round by 180 degrees"},
    {Order::level, "$", 0, 0, "rolls until left is level"},
    {Order::speed, "speed", 1, 1, "lengthens by so many mm a step"},
    {Order::thicken, "thicken", 1, 1, "what is made from now on thickens by so many mm a step"},
    {Order::tropism, "tropism", 1, 1, "turns up by this part of the way, or down if below 0"},
    {Order::bud, "bud", 2, 3,
     "bud(away, round, delay)[...]: a bud so many degrees off the heading, so many round it; it "
     "sprouts so many steps later as what stands in the brackets"},
    {Order::stop, "stop", 0, 0, "lengthens no more"},
};

enum class RuleFunction : std::uint8_t { min, max, abs, sqrt, sin, cos, floor, random };

struct RuleFunctionWord {
    RuleFunction function;
    std::string_view name;
    std::size_t values;
    std::string_view help;
};

inline constexpr RuleFunctionWord kRuleFunctionWords[] = {
    {RuleFunction::min, "min", 2, "the smaller one"},
    {RuleFunction::max, "max", 2, "the larger one"},
    {RuleFunction::abs, "abs", 1, "without its sign"},
    {RuleFunction::sqrt, "sqrt", 1, "square root"},
    {RuleFunction::sin, "sin", 1, "of degrees"},
    {RuleFunction::cos, "cos", 1, "of degrees"},
    {RuleFunction::floor, "floor", 1, "the next whole number below"},
    {RuleFunction::random, "random", 2, "anywhere between two numbers, each alike"},
};

// Names that stand for a number without being set.
struct RuleVariableWord {
    std::string_view name;
    std::string_view help;
};

inline constexpr RuleVariableWord kRuleVariableWords[] = {
    {"step", "steps since the tree began to grow"},
    {"age", "steps since the apex sprouted"},
    {"order", "of branching: 0 for the trunk"},
};

}  // namespace edaha
