// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "geometry/path.h"

namespace edaha {

// Illustrator drops a path of more vertices without a word.
inline constexpr std::size_t kMostPathNodes = 32000;

// The same picture as several paths of at most `most_nodes` nodes each, as far as whole subpaths
// allow: a hole stays with the smallest outline it lies in, their order is kept. A single subpath
// (or an outline with its holes) above the limit stays whole. Where outlines of one path overlap, a
// translucent fill shows it afterwards; those of a union don't.
// Cost: outlines x holes box tests, then a point test where boxes nest.
std::vector<Path> split_path(const Path& path, std::size_t most_nodes = kMostPathNodes);

}  // namespace edaha
