// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "geometry/path.h"

namespace edaha {

// The path cut before each move, in order. The path is well-formed (see Path).
std::vector<Path> subpaths(const Path& path);

// Points that a user would see on the path: one for each move, line and cubic.
std::size_t node_count(const Path& path);

}  // namespace edaha
