// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "drawing/paint.h"

namespace edaha {

// The 147 colour keywords of SVG 1.1 (4.4, "Recognized color keyword names"); capitals don't
// matter.
std::optional<Colour> named_colour(std::string_view name);

// In alphabetical order, for "did you mean".
std::span<const std::string> colour_names();

}  // namespace edaha
