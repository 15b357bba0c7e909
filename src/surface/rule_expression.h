// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/keyed_random.h"
#include "surface/rule_words.h"

namespace edaha {

// Arithmetic of the rules, compiled: what to do with a stack of numbers, one after the other.
struct RuleExpression {
    enum class Op : std::uint8_t {
        number,
        value,     // of the module: index
        variable,  // of kRuleVariableWords: index
        negate,
        invert,
        add,
        subtract,
        multiply,
        divide,
        remainder,
        power,
        less,
        less_equal,
        greater,
        greater_equal,
        equal,
        unequal,
        both,
        either,
        function  // of kRuleFunctionWords: index
    };
    struct Node {
        Op op = Op::number;
        std::uint32_t index = 0;
        double number = 0;
    };
    std::vector<Node> nodes;  // empty: there is none
    std::size_t offset = 0;   // in the text, for errors
};

// What an expression is evaluated among. `draw` counts up with each random number.
struct RuleScope {
    std::span<const double> values;
    std::span<const double> variables;  // in the order of kRuleVariableWords
    const KeyedRandom* random = nullptr;
    Key key = 0;
    std::uint32_t draw = 0;
};

// Truth is 1, all but 0 is true. May be no finite number.
double evaluate(const RuleExpression& expression, RuleScope& scope);

}  // namespace edaha
