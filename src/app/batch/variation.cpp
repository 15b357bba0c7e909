// SPDX-License-Identifier: MIT
#include "app/batch/variation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "base/keyed_random.h"
#include "base/number_text.h"
#include "style/value.h"

namespace edaha {
namespace {

// After those of growth, limbs and ornaments.
constexpr std::uint32_t kVariationPurpose = 1000;

// Whole powers of ten up to this are doubles.
constexpr std::array kPowersOfTen{1.,  1e1, 1e2, 1e3,  1e4,  1e5, 1e6,
                                  1e7, 1e8, 1e9, 1e10, 1e11, 1e12};

std::vector<std::string> split(std::string_view text, std::string_view mark) {
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find(mark);
        parts.emplace_back(trim(text.substr(0, end)));
        if (end != std::string_view::npos) text.remove_prefix(end + mark.size());
    }
    return parts;
}

std::string where(const Variation& variation) {
    const bool names_it = variation.option == "--set" || variation.option == "--sweep";
    return variation.option + ": " + (names_it ? variation.key() + ": " : "");
}

void check_values(const Variation& variation) {
    if (variation.parameter == nullptr) return;
    Style scratch;
    for (const std::string& value : variation.values) {
        if (const auto wrong = assign(scratch, *variation.parameter, value))
            throw UsageError(where(variation) + *wrong);
    }
}

template <class Kind>
bool is(const Variation& variation) {
    return variation.parameter != nullptr &&
           std::holds_alternative<Kind>(variation.parameter->field);
}

// Ends of a..b, where that is no value itself.
bool may_lie_between(const Variation& variation) {
    return (is<Number>(variation) || is<Integer>(variation) || is<Tint>(variation)) &&
           variation.given.find("..") != std::string::npos;
}

std::size_t pick(double u, std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(u * static_cast<double>(count)));
}

double chance(const Variation& variation, std::uint64_t seed) {
    return KeyedRandom(0, seed, 1).uniform(name_key(variation.key()), kVariationPurpose);
}

// How far from the first end to the second.
double way(const Variation& variation, const Position& position) {
    if (!variation.swept) return chance(variation, position.seed);
    if (position.count < 2) return 0;
    return static_cast<double>(position.index) / static_cast<double>(position.count - 1);
}

// With as many decimals as tell steps apart to a thousandth.
double rounded(double value, double step) {
    std::size_t decimals = 0;
    while (decimals + 1 < kPowersOfTen.size() && step * kPowersOfTen[decimals] < 1000)
        ++decimals;
    const double units = value * kPowersOfTen[decimals];
    return std::abs(units) < 0x1p52 ? std::round(units) / kPowersOfTen[decimals] : value;
}

std::string number_between(const Variation& variation, const Position& position) {
    const double from = *parse_number(variation.values.front());
    const double to = *parse_number(variation.values.back());
    const double u = way(variation, position);
    if (u <= 0 || u >= 1) return shortest_text(u <= 0 ? from : to);
    const double steps = variation.swept ? static_cast<double>(position.count - 1) : 1;
    const double value = rounded(from + (to - from) * u, std::abs(to - from) / steps);
    return shortest_text(std::clamp(value, std::min(from, to), std::max(from, to)));
}

std::string integer_between(const Variation& variation, const Position& position) {
    const double from = *parse_number(variation.values.front());
    const double to = *parse_number(variation.values.back());
    const double u = way(variation, position);
    const double value = variation.swept ? std::round(from + (to - from) * u)
                                         : std::min(to, from + std::floor(u * (to - from + 1)));
    return std::to_string(static_cast<std::int64_t>(value));
}

std::string colour_between(const Variation& variation, const Position& position) {
    Style scratch;
    const auto colour = [&](const std::string& text) {
        assign(scratch, *variation.parameter, text);
        return std::get<Tint>(variation.parameter->field).get(scratch);
    };
    const Colour from = colour(variation.values.front());
    const Colour to = colour(variation.values.back());
    const double u = way(variation, position);
    const auto mixed = [u](std::uint8_t a, std::uint8_t b) {
        return static_cast<int>(std::lround(a + (b - a) * u));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(from.r, to.r), mixed(from.g, to.g),
                       mixed(from.b, to.b));
}

void check_between(const Variation& variation) {
    if (variation.swept || is<Tint>(variation)) return;
    if (*parse_number(variation.values.front()) > *parse_number(variation.values.back())) {
        throw UsageError(
            fmt::format("{}{} is a reversed range", where(variation), in_quotes(variation.given)));
    }
}

}  // namespace

Setting parse_assignment(const std::string& option, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        throw UsageError(fmt::format("{}: {} is not an assignment (expected group.name=value)",
                                     option, in_quotes(assignment)));
    }
    return {option, assignment.substr(0, equals), assignment.substr(equals + 1)};
}

Variation parse_variation(const Setting& setting, bool swept) {
    Variation variation{setting.option, nullptr, std::string(trim(setting.value)), {}, swept, {}};
    if (setting.key != "palette") {
        variation.parameter = find_parameter(setting.key);
        if (variation.parameter == nullptr)
            throw UsageError(setting.option + ": " + unknown_parameter(setting.key));
    }
    if (setting.key == "variant.seed")
        throw UsageError(setting.option + ": variant.seed: batch counts it from --seed-from");
    variation.values = split(variation.given, "|");
    if (variation.values.size() > 1) {
        variation.kind = Variation::Kind::one_of;
    } else if (may_lie_between(variation)) {
        variation.kind = Variation::Kind::between;
        const std::size_t dots = variation.given.find("..");
        variation.values = {std::string(trim(variation.given.substr(0, dots))),
                            std::string(trim(variation.given.substr(dots + 2)))};
    }
    check_values(variation);
    if (variation.kind == Variation::Kind::between) check_between(variation);
    if (swept && variation.kind == Variation::Kind::fixed) {
        throw UsageError(fmt::format(
            "{}{} is one value (expected a|b|c{})", where(variation), in_quotes(variation.given),
            is<Number>(variation) || is<Integer>(variation) || is<Tint>(variation) ? " or a..b"
                                                                                   : ""));
    }
    return variation;
}

std::string value_at(const Variation& variation, const Position& position) {
    if (variation.kind == Variation::Kind::fixed) return variation.given;
    if (variation.kind == Variation::Kind::one_of) {
        const std::size_t count = variation.values.size();
        return variation.values[variation.swept ? position.index % count
                                                : pick(chance(variation, position.seed), count)];
    }
    if (is<Number>(variation)) return number_between(variation, position);
    if (is<Integer>(variation)) return integer_between(variation, position);
    return colour_between(variation, position);
}

}  // namespace edaha
