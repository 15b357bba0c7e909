// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace edaha {

// A segment shorter than this (all its points together) has no length: a millionth of a millimetre,
// the writers' finest step. The same is granted at the page's edge for rounding.
inline constexpr double kShortestSegment_mm = 1e-6;

// Every breach of the contract in drawing.h, one line each, naming the place: "layer 'Wood', shape
// 'limb-3': subpath 1 is filled but not closed". Empty for a drawing that keeps it. After
// kMostBreaches the rest is only counted. Time linear in nodes and in uses times the shapes of
// their symbol.
inline constexpr std::size_t kMostBreaches = 100;
std::vector<std::string> check(const Drawing& drawing);

}  // namespace edaha
