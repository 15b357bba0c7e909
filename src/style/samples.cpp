// SPDX-License-Identifier: MIT
#include "style/samples.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/number_text.h"
#include "style/built_in.h"
#include "style/value.h"

namespace edaha {
namespace {

constexpr int kCount = 5;

// Above this factor even steps would show small values only once.
constexpr double kGeometric = 8;

// The widest limits that are a usual range by themselves.
constexpr double kNarrow = 1;

// As somebody would type it: three digits.
std::string plain(double value) {
    return shortest_text(*parse_number(fmt::format("{:.3g}", value)));
}

// The i-th of kCount values from one end to the other.
double stop(const Range& range, double i) {
    const double u = i / (kCount - 1);
    if (range.low > 0 && range.high >= kGeometric * range.low)
        return range.low * std::pow(range.high / range.low, u);
    return range.at(u);
}

template <class Text>
std::vector<std::string> five(const Text& text) {
    std::vector<std::string> values;
    for (int i = 0; i < kCount; ++i)
        values.push_back(text(i));
    return values;
}

std::vector<std::string> intervals(const Range& range) {
    return five([&](int i) {
        if (range.low == -range.high) {
            const double reach = range.high * (i + 1) / kCount;
            return plain(-reach) + ".." + plain(reach);
        }
        const double part = 1.0 / kCount;
        return plain(range.at(i * part)) + ".." + plain(range.at((i + 1) * part));
    });
}

// Bark tiles lie on the same shelf, and are known by their names.
std::vector<std::string> drawings(bool bark) {
    std::vector<std::string> names;
    for (const BuiltIn& file : built_in_leaves()) {
        if (file.name.starts_with("bark-") == bark) names.emplace_back(file.name);
    }
    return names;
}

std::vector<std::string> some_leaves() {
    const std::vector<std::string> leaves = drawings(false);
    return five([&](int i) {
        return leaves[static_cast<std::size_t>(i) * (leaves.size() - 1) / (kCount - 1)];
    });
}

}  // namespace

Range usual_range(const Parameter& parameter) {
    if (parameter.usual.low < parameter.usual.high) return parameter.usual;
    const Limits& limits = parameter.limits;
    if (limits.most - limits.least <= kNarrow) return {limits.least, limits.most};
    return {};
}

std::vector<std::string> samples(const Parameter& parameter) {
    if (std::holds_alternative<Flag>(parameter.field)) return {"no", "yes"};
    if (const auto* choice = std::get_if<Choice>(&parameter.field)) return choice->names;
    if (std::holds_alternative<Reference>(parameter.field))
        return parameter.name == "bark-tile" ? drawings(true) : some_leaves();
    const Range range = usual_range(parameter);
    if (range.low == range.high) return {};
    if (std::holds_alternative<Interval>(parameter.field)) return intervals(range);
    const bool whole = std::holds_alternative<Integer>(parameter.field);
    std::vector<std::string> values = five([&](int i) {
        const double value = stop(range, i);
        return plain(whole ? std::round(value) : value);
    });
    // There may be fewer whole numbers than that.
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace edaha
