// SPDX-License-Identifier: MIT
#include "flatten/box_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "geometry/cell_grid.h"

namespace edaha {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;
using Indices = std::vector<std::uint32_t>;

// More boxes in a cell than this, and it is divided again; if that leaves more than this share of
// them in one of its cells, they lie on each other and dividing is of no use.
constexpr std::size_t kCrowd = 48;
constexpr double kBundle = 0.7;

bool overlap(const TriangleBox& a, const TriangleBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

GridBox common(const GridBox& a, const GridBox& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

constexpr GridBox kEverywhere{{-kGridLimit, -kGridLimit}, {kGridLimit, kGridLimit}};

class PairFinder {
  public:
    explicit PairFinder(std::span<const TriangleBox> boxes) : boxes_(boxes) {}

    struct Cells {
        CellGrid grid;
        Indices first, entries;
        std::size_t most = 0;  // boxes of a cell that is worth dividing
    };

    Cells divide(std::span<const std::uint32_t> items, const GridBox& within) const {
        Cells cells;
        GridBox all;
        double area = 0, sides = 0;
        for (const std::uint32_t i : items) {
            const TriangleBox& box = boxes_[i];
            all.include(on_screen(box.min)), all.include(on_screen(box.max));
            const double width = double(box.max.x) - box.min.x,
                         height = double(box.max.y) - box.min.y;
            area += width * height;
            sides += width + height;
        }
        // So large that a box has not more than some ten entries on the average.
        const double count = double(std::max<std::size_t>(items.size(), 1));
        const double smallest = std::max(std::sqrt(area / (4 * count)), sides / (4 * count));
        cells.grid = make_cell_grid(common(all, within), items.size(), smallest);
        cells.most = static_cast<std::size_t>(kBundle * double(items.size()));
        cells.first.assign(cells.grid.cells() + 2, 0);
        for (const std::uint32_t i : items)
            visit_cells(cells.grid, i, [&](std::size_t cell) { ++cells.first[cell + 2]; });
        std::partial_sum(cells.first.begin(), cells.first.end(), cells.first.begin());
        cells.entries.resize(cells.first.back());
        for (const std::uint32_t i : items) {
            visit_cells(cells.grid, i,
                        [&](std::size_t cell) { cells.entries[cells.first[cell + 1]++] = i; });
        }
        return cells;
    }

    void visit_column(const Cells& cells, std::int64_t column, const GridBox& within,
                      Pairs& found) const {
        for (std::int64_t row = 0; row < cells.grid.rows; ++row) {
            const std::size_t cell = cells.grid.cell(column, row);
            const std::span<const std::uint32_t> items(
                cells.entries.data() + cells.first[cell],
                cells.entries.data() + cells.first[cell + 1]);
            const GridBox box = common(cells.grid.box_of(column, row), within);
            if (items.size() > kCrowd && items.size() < cells.most) {
                const Cells smaller = divide(items, box);
                for (std::int64_t i = 0; i < smaller.grid.columns; ++i)
                    visit_column(smaller, i, box, found);
            } else {
                compare_all(items, box, found);
            }
        }
    }

  private:
    template <typename Visit>
    void visit_cells(const CellGrid& grid, std::uint32_t item, const Visit& visit) const {
        const TriangleBox& box = boxes_[item];
        const std::int64_t right = std::min(grid.column(box.max.x), grid.columns - 1);
        const std::int64_t bottom = std::min(grid.row(box.max.y), grid.rows - 1);
        const std::int64_t top = std::max<std::int64_t>(grid.row(box.min.y), 0);
        std::int64_t column = std::max<std::int64_t>(grid.column(box.min.x), 0);
        for (; column <= right; ++column) {
            for (std::int64_t row = top; row <= bottom; ++row)
                visit(grid.cell(column, row));
        }
    }

    // A pair counts where both boxes begin, from above and from the left.
    void compare_all(std::span<const std::uint32_t> items, const GridBox& within,
                     Pairs& found) const {
        for (std::size_t i = 0; i < items.size(); ++i) {
            const TriangleBox& a = boxes_[items[i]];
            for (std::size_t j = i + 1; j < items.size(); ++j) {
                const TriangleBox& b = boxes_[items[j]];
                if (!overlap(a, b)) continue;
                const std::int32_t x = std::max(a.min.x, b.min.x), y = std::max(a.min.y, b.min.y);
                if (x < within.min.x || x > within.max.x || y < within.min.y || y > within.max.y)
                    continue;
                found.push_back({std::min(items[i], items[j]), std::max(items[i], items[j])});
            }
        }
    }

    std::span<const TriangleBox> boxes_;
};

}  // namespace

Pairs overlapping_pairs(std::span<const TriangleBox> boxes) {
    Indices all(boxes.size());
    std::iota(all.begin(), all.end(), 0U);
    const PairFinder finder(boxes);
    const PairFinder::Cells cells = finder.divide(all, kEverywhere);
    return gather_chunks<std::array<std::uint32_t, 2>>(
        static_cast<std::size_t>(cells.grid.columns), 2, [&](std::size_t column, Pairs& found) {
            finder.visit_column(cells, static_cast<std::int64_t>(column), kEverywhere, found);
        });
}

}  // namespace edaha
