// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "geometry/cell_grid.h"
#include "geometry/grid_point.h"

namespace edaha {

// Small groups of indices such that every two segments that meet are in a group together, and
// every point is in exactly one group with all segments within one step of it. Uniform cells;
// crowded cells are divided again. Groups and their order depend on the input alone. Segments and
// points must outlive it. Expected time linear in the number of items and meetings.
class NeighbourGroups {
  public:
    using Visit = std::function<void(std::span<const std::uint32_t> segments,
                                     std::span<const std::uint32_t> points)>;

    // Of segments alone.
    explicit NeighbourGroups(std::span<const GridSegment> segments);

    // Puts the points in too, which lie within the segments' box.
    void add_points(std::span<const GridPoint> points);

    // What visit(segments, points, found) appends to `found` for all groups in their order; by
    // several threads if there are many segments.
    template <typename Value, typename Visitor>
    std::vector<Value> gather(const Visitor& visit) const;

  private:
    // Lists of indices, one a cell, in one array.
    struct Lists {
        std::vector<std::uint32_t> first, entries;
        std::span<const std::uint32_t> of(std::size_t cell) const {
            return {entries.data() + first[cell], entries.data() + first[cell + 1]};
        }
    };
    struct Cells {
        CellGrid grid;
        Lists segments, points;
        std::size_t most = 0;  // items of a cell that is worth dividing
    };

    struct Entry {
        std::uint32_t cell = 0, index = 0;
    };
    static Lists make_lists(std::size_t cells, std::span<const Entry> entries);
    Lists list_segments(const CellGrid& grid, std::span<const std::uint32_t> segments) const;
    Lists list_points(const CellGrid& grid, std::span<const std::uint32_t> points) const;
    Cells divide(const GridBox& box, std::span<const std::uint32_t> segments,
                 std::span<const std::uint32_t> points) const;
    void visit_column(const Cells& cells, std::int64_t column, const Visit& visit) const;
    double mean_length(std::span<const std::uint32_t> segments) const;

    std::span<const GridSegment> segments_;
    std::span<const GridPoint> points_;
    Cells cells_;
};

template <typename Value, typename Visitor>
std::vector<Value> NeighbourGroups::gather(const Visitor& visit) const {
    constexpr std::size_t kWorthThreads = 20'000;  // segments: some milliseconds
    const auto columns = static_cast<std::size_t>(cells_.grid.columns);
    const std::size_t least = segments_.size() < kWorthThreads ? columns + 1 : 0;
    return gather_chunks<Value>(columns, least, [&](std::size_t column, std::vector<Value>& found) {
        visit_column(cells_, static_cast<std::int64_t>(column),
                     [&](auto near, auto places) { visit(near, places, found); });
    });
}

}  // namespace edaha
