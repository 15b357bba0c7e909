// SPDX-License-Identifier: MIT
#include "surface/rule_expression.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/stable_math.h"
#include "surface/surface_purposes.h"

namespace edaha {
namespace {

using Op = RuleExpression::Op;

// Whole powers of anything, others of what is above 0.
double power(double base, double exponent) {
    if (exponent == std::floor(exponent) && std::abs(exponent) <= 64) {
        double product = 1;
        for (double i = 0; i < std::abs(exponent); ++i)
            product *= base;
        return exponent < 0 ? 1 / product : product;
    }
    if (base == 0 && exponent > 0) return 0;
    return base > 0 && std::isfinite(base) && std::abs(exponent) < 64 ? stable::pow(base, exponent)
                                                                      : std::nan("");
}

stable::SinCos of_degrees(double degrees) {
    return stable::sin_cos(std::fmod(degrees, 360) * std::numbers::pi / 180);
}

double of_two(Op op, double a, double b) {
    switch (op) {
        case Op::add:
            return a + b;
        case Op::subtract:
            return a - b;
        case Op::multiply:
            return a * b;
        case Op::divide:
            return a / b;
        case Op::remainder:
            return a - b * std::floor(a / b);
        case Op::power:
            return power(a, b);
        case Op::less:
            return a < b ? 1 : 0;
        case Op::less_equal:
            return a <= b ? 1 : 0;
        case Op::greater:
            return a > b ? 1 : 0;
        case Op::greater_equal:
            return a >= b ? 1 : 0;
        case Op::equal:
            return a == b ? 1 : 0;
        case Op::unequal:
            return a != b ? 1 : 0;
        case Op::both:
            return a != 0 && b != 0 ? 1 : 0;
        default:
            return a != 0 || b != 0 ? 1 : 0;
    }
}

class Stack {
  public:
    explicit Stack(RuleScope& scope) : scope_(scope) {}

    void push(double x) { numbers_.push_back(x); }
    double pop() {
        const double x = numbers_.back();
        numbers_.pop_back();
        return x;
    }

    void call(RuleFunction function) {
        const double b = pop();
        switch (function) {
            case RuleFunction::min:
                return push(std::min(pop(), b));
            case RuleFunction::max:
                return push(std::max(pop(), b));
            case RuleFunction::abs:
                return push(std::abs(b));
            case RuleFunction::sqrt:
                return push(std::sqrt(b));
            case RuleFunction::sin:
                return push(of_degrees(b).sin);
            case RuleFunction::cos:
                return push(of_degrees(b).cos);
            case RuleFunction::floor:
                return push(std::floor(b));
            case RuleFunction::random: {
                const double a = pop();
                const double u =
                    scope_.random->uniform(scope_.key, surface::kRuleNumber, scope_.draw++);
                return push(a + (b - a) * u);
            }
        }
    }

  private:
    RuleScope& scope_;
    std::vector<double> numbers_;
};

}  // namespace

double evaluate(const RuleExpression& expression, RuleScope& scope) {
    Stack stack(scope);
    for (const RuleExpression::Node& node : expression.nodes) {
        switch (node.op) {
            case Op::number:
                stack.push(node.number);
                break;
            case Op::value:
                stack.push(scope.values[node.index]);
                break;
            case Op::variable:
                stack.push(scope.variables[node.index]);
                break;
            case Op::negate:
                stack.push(-stack.pop());
                break;
            case Op::invert:
                stack.push(stack.pop() == 0 ? 1 : 0);
                break;
            case Op::function:
                stack.call(kRuleFunctionWords[node.index].function);
                break;
            default: {
                const double b = stack.pop(), a = stack.pop();
                stack.push(of_two(node.op, a, b));
            }
        }
    }
    return stack.pop();
}

}  // namespace edaha
