// SPDX-License-Identifier: MIT
#include "geometry/neighbours.h"

#include <cmath>
#include <numeric>

namespace edaha {
namespace {

// A group larger than this is divided: smaller, and dividing costs more than comparing all with
// all; much larger, and comparing becomes quadratic.
constexpr std::size_t kCrowd = 40;
// A cell that keeps more than this share of its parent's items holds a bundle of nearly coincident
// segments: dividing it again would only multiply the work.
constexpr double kBundle = 0.7;
// Cells are no smaller than this share of the mean length, so that long segments don't fill
// thousands of cells each.
constexpr double kCellPerLength = 1.0 / 32;

std::size_t most_worth_dividing(std::size_t items) {
    return static_cast<std::size_t>(kBundle * static_cast<double>(items));
}

std::vector<std::uint32_t> all(std::size_t count) {
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace

NeighbourGroups::NeighbourGroups(std::span<const GridSegment> segments) : segments_(segments) {
    GridBox box;
    for (const GridSegment& s : segments)
        box.include(s.a), box.include(s.b);
    if (segments.empty()) box = {{0, 0}, {0, 0}};
    cells_ = divide(box, all(segments.size()), {});
}

void NeighbourGroups::add_points(std::span<const GridPoint> points) {
    points_ = points;
    cells_.points = list_points(cells_.grid, all(points.size()));
    cells_.most = most_worth_dividing(segments_.size() + points.size());
}

NeighbourGroups::Lists NeighbourGroups::make_lists(std::size_t cells,
                                                   std::span<const Entry> entries) {
    Lists lists;
    lists.first.assign(cells + 2, 0);
    for (const Entry& entry : entries)
        ++lists.first[entry.cell + 2];
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.entries.resize(entries.size());
    for (const Entry& entry : entries)
        lists.entries[lists.first[entry.cell + 1]++] = entry.index;
    return lists;
}

NeighbourGroups::Lists NeighbourGroups::list_segments(
    const CellGrid& grid, std::span<const std::uint32_t> segments) const {
    const auto entries =
        edaha::gather<Entry>(segments.size(), [&](std::size_t i, std::vector<Entry>& found) {
            grid.visit_cells(segments_[segments[i]], [&](std::size_t cell) {
                found.push_back({static_cast<std::uint32_t>(cell), segments[i]});
            });
        });
    return make_lists(grid.cells(), entries);
}

NeighbourGroups::Lists NeighbourGroups::list_points(const CellGrid& grid,
                                                    std::span<const std::uint32_t> points) const {
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for (const std::uint32_t i : points)
        entries.push_back({static_cast<std::uint32_t>(grid.cell_of(points_[i])), i});
    return make_lists(grid.cells(), entries);
}

NeighbourGroups::Cells NeighbourGroups::divide(const GridBox& box,
                                               std::span<const std::uint32_t> segments,
                                               std::span<const std::uint32_t> points) const {
    const std::size_t items = std::max(segments.size(), points.size());
    Cells cells;
    cells.most = most_worth_dividing(segments.size() + points.size());
    cells.grid = make_cell_grid(box, items, kCellPerLength * mean_length(segments));
    cells.segments = list_segments(cells.grid, segments);
    cells.points = list_points(cells.grid, points);
    return cells;
}

void NeighbourGroups::visit_column(const Cells& cells, std::int64_t column,
                                   const Visit& visit) const {
    for (std::int64_t row = 0; row < cells.grid.rows; ++row) {
        const std::size_t cell = cells.grid.cell(column, row);
        const auto near = cells.segments.of(cell), places = cells.points.of(cell);
        if (near.empty()) continue;
        const std::size_t count = near.size() + places.size();
        if (count > kCrowd && cells.grid.size > 4 && count < cells.most) {
            const Cells smaller = divide(cells.grid.box_of(column, row), near, places);
            for (std::int64_t i = 0; i < smaller.grid.columns; ++i)
                visit_column(smaller, i, visit);
        } else {
            visit(near, places);
        }
    }
}

double NeighbourGroups::mean_length(std::span<const std::uint32_t> segments) const {
    double sum = 0;
    for (const std::uint32_t i : segments) {
        const GridVector d = segments_[i].b - segments_[i].a;
        sum += static_cast<double>(std::abs(d.x) + std::abs(d.y));
    }
    return segments.empty() ? 0 : sum / static_cast<double>(segments.size());
}

}  // namespace edaha
