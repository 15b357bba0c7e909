// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "geometry/grid_point.h"

namespace edaha {

// Calls visit(segments, points) with small groups of indices such that every two segments that
// meet are in a group together, and every point is in exactly one group with all segments within
// one step of it. Uniform cells; crowded cells are divided again. Expected time linear in the
// number of items and meetings. Groups and their order depend on the input alone.
using VisitNeighbours = std::function<void(std::span<const std::uint32_t> segments,
                                           std::span<const std::uint32_t> points)>;

void visit_neighbours(std::span<const GridSegment> segments, std::span<const GridPoint> points,
                      const VisitNeighbours& visit);

}  // namespace edaha
