// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/options.h"
#include "style/parameter.h"

namespace edaha {

// What one option of batch gives to a parameter, or to the palette: the same value for all
// variants, or one for each.
//   a..b   a number, whole number or colour between the two: by chance, or swept evenly
//   a|b|c  one of these: by chance, or swept in turn
//   other  this value; also a..b where that is itself a value (of a range)
struct Variation {
    enum class Kind { fixed, between, one_of };

    std::string option;                    // "--set", "--vary": as it was given, and is recorded
    const Parameter* parameter = nullptr;  // null: the palette
    std::string given;
    Kind kind = Kind::fixed;
    bool swept = false;
    std::vector<std::string> values;  // the value; both ends; or all there are

    std::string key() const { return parameter != nullptr ? parameter->key() : "palette"; }
};

// Every value it can give is good for its parameter (a palette's name is not looked up).
// Errors: UsageError, in the table's words.
Variation parse_variation(const Setting& setting, bool swept);

// "growth.energy=100..800" as a setting of its parameter. Errors: UsageError.
Setting parse_assignment(const std::string& option, const std::string& assignment);

// Which variant of a style a value is for.
struct Position {
    std::uint64_t seed = 0;
    std::size_t index = 0;  // from 0
    std::size_t count = 1;
};

// The value as users write it. What is drawn by chance is uniform, and depends on the seed and the
// parameter alone: not on other variants, parameters or how members of a family vary. Numbers have
// as few decimals as tell a thousandth of the range apart, swept ones of a step.
std::string value_at(const Variation& variation, const Position& position);

}  // namespace edaha
