// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cover.h"

namespace edaha {

// A part of a ring of half-edges that follows one source ring without a break. Places on a source
// ring count chords from its first one, with fractions, and go on counting past its end: a run
// goes from `begin` to `end`, downwards if it runs against its source.
struct BorderRun {
    std::uint32_t ring = 0;
    bool forward = true;
    double begin = 0, end = 0;
    GridPoint start, stop;               // nodes
    std::uint32_t first = 0, count = 0;  // half-edges of the ring, counted round it
};

// The runs round a closed ring. Where several sources coincide the one that is being followed
// goes on. Where the border leaves a source and comes back to it, having stayed within `reach`
// grid steps of it (two nearly tangent outlines weave), it counts as not having left.
std::vector<BorderRun> border_runs(const Cover& cover, std::span<const std::uint32_t> ring,
                                   double reach);

}  // namespace edaha
