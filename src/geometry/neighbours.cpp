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

std::vector<std::uint32_t> all(std::size_t count) {
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace

NeighbourGroups::NeighbourGroups(std::span<const GridSegment> segments,
                                 std::span<const GridPoint> points)
    : segments_(segments), points_(points) {
    GridBox box;
    for (const GridSegment& s : segments)
        box.include(s.a), box.include(s.b);
    for (const GridPoint& p : points)
        box.include(p);
    if (segments.empty()) box = {{0, 0}, {0, 0}};
    cells_ = divide(box, all(segments.size()), all(points.size()));
}

// for_each(add) calls add(cell, index) for every entry; it is run twice.
template <typename ForEach>
NeighbourGroups::Lists NeighbourGroups::make_lists(std::size_t cells, ForEach&& for_each) {
    Lists lists;
    lists.first.assign(cells + 2, 0);
    for_each([&](std::size_t cell, std::uint32_t) { ++lists.first[cell + 2]; });
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.entries.resize(lists.first.back());
    for_each([&](std::size_t cell, std::uint32_t index) {
        lists.entries[lists.first[cell + 1]++] = index;
    });
    return lists;
}

NeighbourGroups::Cells NeighbourGroups::divide(const GridBox& box,
                                               std::span<const std::uint32_t> segments,
                                               std::span<const std::uint32_t> points) const {
    Cells cells;
    cells.most = static_cast<std::size_t>(kBundle * double(segments.size() + points.size()));
    cells.grid = make_cell_grid(box, std::max(segments.size(), points.size()),
                                kCellPerLength * mean_length(segments));
    cells.segments = make_lists(cells.grid.cells(), [&](auto&& add) {
        for (const std::uint32_t i : segments)
            cells.grid.visit_cells(segments_[i], [&](std::size_t cell) { add(cell, i); });
    });
    cells.points = make_lists(cells.grid.cells(), [&](auto&& add) {
        for (const std::uint32_t i : points)
            add(cells.grid.cell_of(points_[i]), i);
    });
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
