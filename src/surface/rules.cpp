// SPDX-License-Identifier: MIT
#include "surface/rules.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/locate.h"
#include "base/stable_math.h"
#include "surface/rule_program.h"
#include "surface/surface_purposes.h"

namespace edaha {
namespace {

constexpr double kRad = std::numbers::pi / 180;

// Turns one column of a frame towards another.
void turn(glm::dmat3& frame, int from, int to, double degrees) {
    const auto [sine, cosine] = stable::sin_cos(std::fmod(degrees, 360) * kRad);
    const Vec3 a = frame[from], b = frame[to];
    frame[from] = a * cosine + b * sine;
    frame[to] = b * cosine - a * sine;
}

// Square and of length 1 again, after many turns.
void straighten(glm::dmat3& frame) {
    frame[0] = glm::normalize(frame[0]);
    frame[1] = glm::normalize(frame[1] - frame[0] * glm::dot(frame[0], frame[1]));
    frame[2] = glm::cross(frame[0], frame[1]);
}

// Heading turned towards up by a part of the angle between, or away from it.
void bend(glm::dmat3& frame, double part) {
    const Vec3 heading = frame[0], up(0, 1, 0);
    const double sine = glm::length(glm::cross(heading, up));
    if (sine < 1e-9) return;
    const double angle = stable::atan2(sine, heading.y);
    const double by = std::clamp(part < 0 ? part * (std::numbers::pi - angle) : part * angle,
                                 -std::numbers::pi, std::numbers::pi);
    const Vec3 axis = glm::cross(heading, up) / sine;
    const auto [s, c] = stable::sin_cos(by);
    for (int i = 0; i < 3; ++i) {
        const Vec3 v = frame[i];
        frame[i] = v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
    }
}

void make_level(glm::dmat3& frame) {
    const Vec3 left = glm::cross(Vec3(0, 1, 0), frame[0]);
    if (glm::length(left) < 1e-9) return;
    frame[1] = glm::normalize(left);
    frame[2] = glm::cross(frame[0], frame[1]);
}

// Carries out one step of one apex.
class Rewriter {
  public:
    Rewriter(const Rules& rules, ApexState& apex, const KeyedRandom& random, std::int64_t step)
        : rules_(rules),
          apex_(apex),
          variables_{static_cast<double>(step), static_cast<double>(apex.age),
                     static_cast<double>(apex.order)},
          values_(apex.module ? apex.module->values : std::vector<double>{}) {
        scope_.values = values_;
        scope_.variables = variables_;
        scope_.random = &random;
        scope_.key = edaha::step(apex.key, static_cast<std::uint64_t>(apex.age));
    }

    std::vector<Bud> run() {
        const Production* production = apex_.module ? choose() : nullptr;
        if (production != nullptr) {
            apex_.module.reset();
            carry_out(production->successor, apex_);
            straighten(apex_.frame);
        }
        ++apex_.age;
        return std::move(buds_);
    }

    void carry_out(const std::vector<RuleItem>& items, ApexState& state) {
        for (const RuleItem& item : items) {
            if (item.is_module) {
                state.module = Module{item.symbol, {}};
                for (const RuleExpression& value : item.values)
                    state.module->values.push_back(number(value));
            } else {
                obey(item, state);
            }
        }
    }

  private:
    double number(const RuleExpression& expression) {
        const double x = evaluate(expression, scope_);
        if (std::isfinite(x) && std::abs(x) < 1e12) return x;
        const Place place = place_of_offset(rules_.text, expression.offset, rules_.file);
        throw InputError({{{place.file, place.line + rules_.first_line - 1, place.column},
                           "the rules lead to a value that is no finite number here"}});
    }

    const Production* choose() {
        std::vector<std::pair<const Production*, double>> weighted;
        double sum = 0;
        for (const Production& production : rules_.productions) {
            if (production.symbol != apex_.module->symbol || production.values != values_.size())
                continue;
            if (!production.condition.nodes.empty() && number(production.condition) == 0) continue;
            if (production.weight.nodes.empty()) {
                if (weighted.empty()) return &production;
                break;
            }
            weighted.emplace_back(&production, std::max(0.0, number(production.weight)));
            sum += weighted.back().second;
        }
        double left = sum * scope_.random->uniform(scope_.key, surface::kRuleChoice);
        for (const auto& [production, weight] : weighted) {
            left -= weight;
            if (left < 0) return production;
        }
        return nullptr;
    }

    void obey(const RuleItem& item, ApexState& state) {
        const double value = item.values.empty() ? rules_.angle : number(item.values[0]);
        switch (item.order) {
            case Order::left:
                return turn(state.frame, 0, 1, value);
            case Order::right:
                return turn(state.frame, 0, 1, -value);
            case Order::down:
                return turn(state.frame, 0, 2, -value);
            case Order::up:
                return turn(state.frame, 0, 2, value);
            case Order::roll_left:
                return turn(state.frame, 2, 1, value);
            case Order::roll_right:
                return turn(state.frame, 2, 1, -value);
            case Order::turn_round:
                return turn(state.frame, 0, 1, 180);
            case Order::level:
                return make_level(state.frame);
            case Order::speed:
                state.speed_mm = std::max(0.0, value);
                return;
            case Order::thicken:
                state.thickening_mm = std::max(0.0, value);
                return;
            case Order::tropism:
                return bend(state.frame, std::clamp(value, -1.0, 1.0));
            case Order::stop:
                state.stopped = true;
                return;
            case Order::bud:
                return make_bud(item, state);
        }
    }

    void make_bud(const RuleItem& item, const ApexState& state) {
        Bud bud;
        bud.state = state;
        turn(bud.state.frame, 1, 2, number(item.values[1]));
        turn(bud.state.frame, 0, 1, number(item.values[0]));
        bud.direction = bud.state.frame[0];
        bud.delay = item.values.size() < 3
                        ? 0
                        : static_cast<std::int64_t>(std::clamp(number(item.values[2]), 0.0, 1e9));
        bud.state.key = edaha::step(apex_.key, 1'000'000 + apex_.buds++);
        bud.state.module.reset();
        bud.state.stopped = false;
        bud.state.age = 0;
        bud.state.buds = 0;
        ++bud.state.order;
        carry_out(item.sprouts, bud.state);
        buds_.push_back(std::move(bud));
    }

    const Rules& rules_;
    ApexState& apex_;
    std::vector<double> variables_, values_;
    RuleScope scope_;
    std::vector<Bud> buds_;
};

}  // namespace

ApexState first_apex(const Rules& rules, double speed_mm, double thickening_mm) {
    ApexState apex;
    // Heading up, left to the left of who looks at it.
    apex.frame = glm::dmat3(Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1));
    apex.speed_mm = speed_mm;
    apex.thickening_mm = thickening_mm;
    const KeyedRandom random(0, 0, 0);
    Rewriter(rules, apex, random, 0).carry_out(rules.axiom, apex);
    straighten(apex.frame);
    return apex;
}

std::vector<Bud> advance(const Rules& rules, ApexState& apex, const KeyedRandom& random,
                         std::int64_t step) {
    return Rewriter(rules, apex, random, step).run();
}

}  // namespace edaha
