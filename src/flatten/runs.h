// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/arc_graph.h"

namespace edaha {

// Arcs in a row, each going on where the one before ends.
struct Run {
    std::uint32_t first = 0, end = 0;  // into RunSet::uses
    bool closed = false;
};

struct RunSet {
    std::vector<ArcUse> uses;
    std::vector<Run> runs;

    std::span<const ArcUse> of(const Run& run) const {
        return {uses.data() + run.first, uses.data() + run.end};
    }
};

// The runs of arcs whose ends are paired: an end is 2 * arc, + 1 for where the arc ends; its
// partner is the end that leaves the same node, kNone where a run ends. Every `wanted` arc is in
// one run, the others in none.
RunSet follow_partners(const ArcSet& arcs, std::span<const std::uint32_t> partner,
                       std::span<const std::uint8_t> wanted);

struct JoinParams {
    double window = 2;      // directions are judged over this length, in the map's steps
    double most_turn = 25;  // degrees: sharper turns end a run
};

// What is to be fitted as one curve: at every node the two arcs that continue each other best, and
// no others, belong to one run; at a T-junction they are the outline of what lies in front. Between
// equally good pairs that of one kind counts. Arcs that vanished are in no run. O(E log E).
RunSet join_arcs(const ArcGraph& graph, const JoinParams& params);

}  // namespace edaha
