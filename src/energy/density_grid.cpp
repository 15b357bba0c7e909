// SPDX-License-Identifier: MIT
#include "energy/density_grid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace edaha {
namespace {

constexpr std::int64_t kMaxDirectory = std::int64_t{1} << 26;
// Beyond this a coordinate in cells can't be told from its neighbour.
constexpr double kMaxCell = 0x1p40;

// Where a segment crosses the lines of one axis: t of the next line, and t from line to line.
struct Crossings {
    double next, pitch;
    std::int64_t step;
};

Crossings crossings(double from, double along, std::int64_t cell) {
    if (along > 0) return {(static_cast<double>(cell + 1) - from) / along, 1 / along, 1};
    if (along < 0) return {(static_cast<double>(cell) - from) / along, -1 / along, -1};
    return {2, 2, 0};  // never within t <= 1
}

}  // namespace

DensityGrid::DensityGrid(double cell_mm) : cells_per_mm_(1 / cell_mm) {}

float& DensityGrid::cell(Cell at) {
    const std::int64_t tile_x = at.x >> kTileBits, tile_y = at.y >> kTileBits;
    widen(tile_x, tile_y);
    const std::int64_t place = (tile_y - bottom_) * columns_ + tile_x - left_;
    std::int32_t& tile = directory_[static_cast<std::size_t>(place)];
    if (tile < 0) {
        tile = static_cast<std::int32_t>(cells_.size() / kTileCells);
        cells_.resize(cells_.size() + kTileCells, 0.0F);
    }
    return cells_[slot(tile, at)];
}

// Doubles the box of the directory towards the tile, so that growing stays linear in all.
void DensityGrid::widen(std::int64_t tile_x, std::int64_t tile_y) {
    const bool inside = tile_x >= left_ && tile_y >= bottom_ && tile_x < left_ + columns_ &&
                        tile_y < bottom_ + rows_;
    if (inside) return;
    std::int64_t left = columns_ > 0 ? left_ : tile_x, right = left + columns_;
    std::int64_t bottom = rows_ > 0 ? bottom_ : tile_y, top = bottom + rows_;
    if (tile_x < left) left = std::min(tile_x, left - columns_);
    if (tile_x >= right) right = std::max(tile_x + 1, right + columns_);
    if (tile_y < bottom) bottom = std::min(tile_y, bottom - rows_);
    if (tile_y >= top) top = std::max(tile_y + 1, top + rows_);
    const std::int64_t columns = right - left, rows = top - bottom;
    if (columns > kMaxDirectory / rows) {
        throw IoError("space.cell: the tree spans too many cells; take wider ones");
    }
    std::vector<std::int32_t> directory(static_cast<std::size_t>(columns * rows), -1);
    for (std::int64_t row = 0; row < rows_; ++row) {
        const auto source = directory_.begin() + row * columns_;
        std::copy(source, source + columns_,
                  directory.begin() + (row + bottom_ - bottom) * columns + (left_ - left));
    }
    directory_ = std::move(directory);
    left_ = left, bottom_ = bottom, columns_ = columns, rows_ = rows;
}

void DensityGrid::add(Vec2 point, double amount) {
    const double furthest = std::max(std::abs(point.x), std::abs(point.y)) * cells_per_mm_;
    if (!(furthest < kMaxCell)) throw IoError("growth.length: the tree is too large for its cells");
    cell(cell_of(point)) += static_cast<float>(amount);
}

// Amanatides & Woo's traversal (1987): from cell to cell, the t at which each is left.
void DensityGrid::add_segment(Vec2 from, Vec2 to, double amount_per_cell) {
    add(to, 0);  // checks the size
    const Vec2 a = from * cells_per_mm_, along = (to - from) * cells_per_mm_;
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    Cell at = cell_of(from);
    Crossings x = crossings(a.x, along.x, at.x), y = crossings(a.y, along.y, at.y);
    for (double t = 0; t < 1;) {
        const double leave = std::min({x.next, y.next, 1.0});
        cell(at) += static_cast<float>((leave - t) * length * amount_per_cell);
        Crossings& crossed = x.next <= y.next ? x : y;
        (x.next <= y.next ? at.x : at.y) += crossed.step;
        crossed.next += crossed.pitch;
        t = leave;
    }
}

}  // namespace edaha
