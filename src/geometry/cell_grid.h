// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "geometry/grid_point.h"

namespace edaha {

// Square cells over a box, for looking up what is near: cell = column * rows + row.
struct CellGrid {
    GridPoint origin;
    std::int64_t size = 1;  // side of a cell, in grid steps
    std::int64_t columns = 1, rows = 1;

    std::size_t cells() const { return static_cast<std::size_t>(columns * rows); }
    std::int64_t column(std::int64_t x) const { return clamped(x - origin.x, columns); }
    std::int64_t row(std::int64_t y) const { return clamped(y - origin.y, rows); }
    std::size_t cell(std::int64_t column, std::int64_t row) const {
        return static_cast<std::size_t>(column * rows + row);
    }
    std::size_t cell_of(GridPoint p) const { return cell(column(p.x), row(p.y)); }
    GridBox box_of(std::int64_t column, std::int64_t row) const;

    // Calls visit(cell) for every cell within one step of the segment, some beside it too.
    template <typename Visit>
    void visit_cells(const GridSegment& segment, Visit&& visit) const;

  private:
    // Outside the box: -1 or `count`.
    std::int64_t clamped(std::int64_t offset, std::int64_t count) const {
        if (offset < 0) return -1;
        return std::min(offset / size, count);
    }
};

// About `items` cells over the box, at least `smallest` wide and never more than 4 `items` + 1.
CellGrid make_cell_grid(const GridBox& box, std::size_t items, double smallest);

template <typename Visit>
void CellGrid::visit_cells(const GridSegment& s, Visit&& visit) const {
    const GridPoint a = s.a.x <= s.b.x ? s.a : s.b;
    const GridPoint b = s.a.x <= s.b.x ? s.b : s.a;
    const auto [low, high] = std::minmax(a.y, b.y);
    const std::int64_t last_column = std::min(column(std::int64_t{b.x} + 1), columns - 1);
    const double slope = a.x < b.x ? (double(b.y) - a.y) / (double(b.x) - a.x) : 0;
    for (std::int64_t i = std::max<std::int64_t>(column(std::int64_t{a.x} - 1), 0);
         i <= last_column; ++i) {
        double bottom = low, top = high;
        if (slope != 0) {  // what the segment covers of this column
            const double x0 = double(origin.x + i * size - 1) - a.x;
            const double y0 = a.y + slope * x0;
            const double y1 = a.y + slope * (x0 + double(size) + 2);
            bottom = std::max(bottom, std::min(y0, y1));
            top = std::min(top, std::max(y0, y1));
        }
        const std::int64_t first = std::max<std::int64_t>(row(std::int64_t(bottom) - 2), 0);
        const std::int64_t last = std::min(row(std::int64_t(top) + 2), rows - 1);
        for (std::int64_t j = first; j <= last; ++j)
            visit(cell(i, j));
    }
}

}  // namespace edaha
