// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/path.h"

namespace edaha {

// How much wood stands in each square cell of the drawing surface (Mama & Nakajima, 2.3).
// Without a fixed canvas: tiles of cells appear as they are first touched. density() and add()
// are O(1). Memory: 4 bytes a cell of the touched tiles, 4 a tile of the box round them all;
// IoError once that box passes 2^26 tiles.
class DensityGrid {
  public:
    explicit DensityGrid(double cell_mm);

    double density(Vec2 point) const;
    void add(Vec2 point, double amount);
    // `amount_per_cell` for each cell's width of the segment that lies in a cell.
    void add_segment(Vec2 from, Vec2 to, double amount_per_cell);

  private:
    static constexpr int kTileBits = 4;  // 16 x 16 cells = 1 KiB: small trees touch few bytes
    static constexpr int kTileCells = 1 << (2 * kTileBits);

    struct Cell {
        std::int64_t x, y;
    };
    Cell cell_of(Vec2 point) const;
    float& cell(Cell at);
    void widen(std::int64_t tile_x, std::int64_t tile_y);

    double cell_mm_;
    double cells_per_mm_;
    std::int64_t left_ = 0, bottom_ = 0;  // first tile of the directory
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<std::int32_t> directory_;  // index of a tile's first cell / kTileCells, or -1
    std::vector<float> cells_;
};

}  // namespace edaha
