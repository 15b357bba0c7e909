// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "base/stable_math.h"
#include "geometry/path.h"

namespace edaha {

// How much wood stands in each square cell of the drawing surface (Mama & Nakajima, 2.3).
// Without a fixed canvas: tiles of cells appear as they are first touched. density() and add()
// are O(1). Memory: 4 bytes a cell of the touched tiles, 4 a tile of the box round them all;
// IoError once that box passes 2^26 tiles.
class DensityGrid {
  public:
    explicit DensityGrid(double cell_mm);

    double density(Vec2 point) const {
        const Cell at = cell_of(point);
        const std::int64_t column = (at.x >> kTileBits) - left_;
        const std::int64_t row = (at.y >> kTileBits) - bottom_;
        // Unsigned: what lies left of or below the directory is beyond it, too.
        const bool known =
            static_cast<std::uint64_t>(column) < static_cast<std::uint64_t>(columns_) &&
            static_cast<std::uint64_t>(row) < static_cast<std::uint64_t>(rows_);
        if (!known) return 0;
        const std::int32_t tile = directory_[static_cast<std::size_t>(row * columns_ + column)];
        return tile < 0 ? 0 : cells_[slot(tile, at)];
    }
    void add(Vec2 point, double amount);
    // `amount_per_cell` for each cell's width of the segment that lies in a cell.
    void add_segment(Vec2 from, Vec2 to, double amount_per_cell);

  private:
    static constexpr int kTileBits = 4;  // 16 x 16 cells = 1 KiB: small trees touch few bytes
    static constexpr int kTileCells = 1 << (2 * kTileBits);

    struct Cell {
        std::int64_t x, y;
    };
    Cell cell_of(Vec2 point) const {
        return {stable::floor(point.x * cells_per_mm_), stable::floor(point.y * cells_per_mm_)};
    }
    static std::size_t slot(std::int32_t tile, Cell at) {
        constexpr std::int64_t mask = (1 << kTileBits) - 1;
        return static_cast<std::size_t>(tile) * kTileCells +
               static_cast<std::size_t>((at.y & mask) << kTileBits | (at.x & mask));
    }
    float& cell(Cell at);
    void widen(std::int64_t tile_x, std::int64_t tile_y);

    double cells_per_mm_;
    std::int64_t left_ = 0, bottom_ = 0;  // first tile of the directory
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<std::int32_t> directory_;  // index of a tile's first cell / kTileCells, or -1
    std::vector<float> cells_;
};

}  // namespace edaha
