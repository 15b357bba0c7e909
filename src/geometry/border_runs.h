// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cover.h"
#include "geometry/region_rings.h"

namespace edaha {

// A part of a ring of half-edges that follows one source ring without a break. Places on a source
// ring count chords from its first one, with fractions, and go on counting past its end: a run
// goes from `begin` to `end`, downwards if it runs against its source.
struct BorderRun {
    std::uint32_t ring = 0;
    bool forward = true;
    bool straight = true;  // all of it
    double begin = 0, end = 0;
    GridPoint start, stop;               // nodes
    std::uint32_t first = 0, count = 0;  // half-edges of the ring, counted round it
};

// Nodes in which rings touch, themselves or each other: 1, else 0. One entry a node.
std::vector<std::uint8_t> touching_nodes(const PlanarMap& map, const RegionRings& rings);

// The runs round a closed ring. Where several sources coincide the one that is being followed
// goes on. Where the border leaves a source and comes back to it, having stayed within `reach`
// grid steps of it (two nearly tangent outlines weave), it counts as not having left. Straight
// runs end in touching nodes, so that polygons don't cross each other by a fraction of a step.
std::vector<BorderRun> border_runs(const Cover& cover, std::span<const std::uint32_t> ring,
                                   std::span<const std::uint8_t> touching, double reach);

}  // namespace edaha
