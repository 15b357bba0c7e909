// SPDX-License-Identifier: MIT
#include "geometry/cell_grid.h"

#include <cmath>

namespace edaha {

GridBox CellGrid::box_of(std::int64_t column, std::int64_t row) const {
    const auto at = [&](std::int64_t i, std::int64_t j) {
        return GridPoint{static_cast<std::int32_t>(origin.x + i * size),
                         static_cast<std::int32_t>(origin.y + j * size)};
    };
    const GridPoint next = at(column + 1, row + 1);
    return {at(column, row), {next.x - 1, next.y - 1}};
}

CellGrid make_cell_grid(const GridBox& box, std::size_t items, double smallest) {
    const double width = double(box.max.x) - box.min.x + 1;
    const double height = double(box.max.y) - box.min.y + 1;
    const double count = static_cast<double>(std::max<std::size_t>(items, 1));
    const double side =
        std::max({std::sqrt(width * height / count), width / count, height / count, smallest, 1.0});
    CellGrid grid;
    grid.origin = box.min;
    grid.size = static_cast<std::int64_t>(std::ceil(side));
    grid.columns = static_cast<std::int64_t>(width - 1) / grid.size + 1;
    grid.rows = static_cast<std::int64_t>(height - 1) / grid.size + 1;
    return grid;
}

}  // namespace edaha
