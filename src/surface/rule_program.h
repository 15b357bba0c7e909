// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "surface/rule_expression.h"
#include "surface/rules.h"

namespace edaha {

// An order or, where it is none, a module that productions may rewrite.
struct RuleItem {
    bool is_module = false;
    Order order = Order::stop;
    std::uint32_t symbol = 0;
    std::vector<RuleExpression> values;
    std::vector<RuleItem> sprouts;  // of a bud
};

struct Production {
    std::uint32_t symbol = 0;
    std::size_t values = 0;
    RuleExpression condition;  // empty: always
    RuleExpression weight;     // empty: not by chance
    std::vector<RuleItem> successor;
};

class Rules {
  public:
    std::vector<std::string> names;  // of modules
    std::vector<RuleItem> axiom;
    std::vector<Production> productions;
    double angle = 22.5;  // degrees, of turns that say none
    std::string text, file;
    int first_line = 1;
};

}  // namespace edaha
