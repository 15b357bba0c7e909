// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "style/parameter.h"

namespace edaha {

// Values of parameters as text, in the units that users write: millimetres, degrees, yes and no,
// #rrggbb, "0.1 0.9" or "0.1..0.9", "0 20 45". Space round a value is no part of it. Locale-free.

// Sets the parameter. If the text is no value for it, nothing is changed and what is wrong comes
// back: "'abc' is not a number (expected 1 … 1e6)".
std::optional<std::string> assign(Style& style, const Parameter& parameter, std::string_view text);

// The value in its one canonical form: the shortest that is read as the same value again.
std::string value_text(const Style& style, const Parameter& parameter);

// "1 … 1e6", "0.5 … 100 mm", "yes or no", "A or B", "#rrggbb".
std::string expected_text(const Parameter& parameter);

// "number", "whole number", "yes or no", "choice", "range", "list by order", "colour", "drawing" ….
std::string kind_text(const Parameter& parameter);

// A piece of somebody's text for a message: in single quotes, cut after 40 characters, without
// control characters.
std::string in_quotes(std::string_view text);

// Without white space at either end.
std::string_view trim(std::string_view text);

// The shortest decimal text that is read as the same number: "0.1", "250000", "1e6".
std::string shortest_text(double value);

}  // namespace edaha
