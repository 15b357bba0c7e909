// SPDX-License-Identifier: MIT
#include "geometry/neighbours.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "geometry/cell_grid.h"

namespace edaha {
namespace {

using Indices = std::vector<std::uint32_t>;

// A group larger than this is divided: smaller, and dividing costs more than comparing all with
// all; much larger, and comparing becomes quadratic.
constexpr std::size_t kCrowd = 40;
// A cell that keeps more than this share of its parent's items holds a bundle of nearly coincident
// segments: dividing it again would only multiply the work.
constexpr double kBundle = 0.7;
// Cells are no smaller than this share of the mean length, so that long segments don't fill
// thousands of cells each.
constexpr double kCellPerLength = 1.0 / 32;

// Lists of indices, one a cell, in one array.
struct Lists {
    std::vector<std::uint32_t> first;
    Indices entries;

    std::span<const std::uint32_t> of(std::size_t cell) const {
        return {entries.data() + first[cell], entries.data() + first[cell + 1]};
    }
};

// for_each(add) calls add(cell, index) for every entry; it is run twice.
template <typename ForEach>
Lists make_lists(std::size_t cells, ForEach&& for_each) {
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

class Divider {
  public:
    Divider(std::span<const GridSegment> segments, std::span<const GridPoint> points,
            const VisitNeighbours& visit)
        : segments_(segments), points_(points), visit_(visit) {}

    void divide(const GridBox& box, std::span<const std::uint32_t> segments,
                std::span<const std::uint32_t> points) {
        const std::size_t most =
            static_cast<std::size_t>(kBundle * double(segments.size() + points.size()));
        const CellGrid grid = make_cell_grid(box, std::max(segments.size(), points.size()),
                                             kCellPerLength * mean_length(segments));
        const Lists near = make_lists(grid.cells(), [&](auto&& add) {
            for (const std::uint32_t i : segments) {
                grid.visit_cells(segments_[i], [&](std::size_t cell) { add(cell, i); });
            }
        });
        const Lists inside = make_lists(grid.cells(), [&](auto&& add) {
            for (const std::uint32_t i : points)
                add(grid.cell_of(points_[i]), i);
        });
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            for (std::int64_t row = 0; row < grid.rows; ++row) {
                const std::size_t cell = grid.cell(column, row);
                const auto few = near.of(cell), places = inside.of(cell);
                if (few.empty()) continue;
                const std::size_t count = few.size() + places.size();
                if (count > kCrowd && grid.size > 4 && count < most) {
                    divide(grid.box_of(column, row), few, places);
                } else {
                    visit_(few, places);
                }
            }
        }
    }

  private:
    double mean_length(std::span<const std::uint32_t> segments) const {
        double sum = 0;
        for (const std::uint32_t i : segments) {
            const GridVector d = segments_[i].b - segments_[i].a;
            sum += static_cast<double>(std::abs(d.x) + std::abs(d.y));
        }
        return segments.empty() ? 0 : sum / static_cast<double>(segments.size());
    }

    std::span<const GridSegment> segments_;
    std::span<const GridPoint> points_;
    const VisitNeighbours& visit_;
};

Indices all(std::size_t count) {
    Indices indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace

void visit_neighbours(std::span<const GridSegment> segments, std::span<const GridPoint> points,
                      const VisitNeighbours& visit) {
    if (segments.empty()) return;
    GridBox box;
    for (const GridSegment& s : segments)
        box.include(s.a), box.include(s.b);
    for (const GridPoint& p : points)
        box.include(p);
    Divider(segments, points, visit).divide(box, all(segments.size()), all(points.size()));
}

}  // namespace edaha
