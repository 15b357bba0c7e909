// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/path.h"

namespace edaha {

// A plane of samples, one bit each: sample (column, row) lies in the middle of its unit square, at
// (column + 0.5, row + 0.5). What lies outside the plane is left out.
class BitRaster {
  public:
    // Both at least 1.
    BitRaster(int columns, int rows);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool at(int column, int row) const { return words_[word(column, row)] >> (column & 63) & 1; }
    std::int64_t count() const;  // of the samples that are set

    // Sets the samples inside a path, under the non-zero rule with subpaths closed, and says how
    // many they are. A sample on the border of two shapes that share it is in one of them.
    // Curves are taken for chords within `tolerance` samples of them. Linear in chords and in rows
    // crossed.
    std::int64_t fill(const Path& path, const Affine& raster_from_path, double tolerance = 0.03);

  private:
    friend class BitStamp;
    std::size_t word(int column, int row) const {
        return static_cast<std::size_t>(row) * stride_ + static_cast<std::size_t>(column >> 6);
    }
    void cross(Vec2 from, Vec2 to, int from_row, int to_row);
    std::int64_t set(int row, int first, int end);

    int columns_, rows_;
    std::size_t stride_;  // words a row
    std::vector<std::uint64_t> words_;
    // Of one path and the rows, reused: row << 32 | samples of the row before it << 1 | downwards.
    std::vector<std::uint64_t> crossings_;
};

// A shape that is set on rasters many times over, turned and scaled: sampled once, by a raster.
class BitStamp {
  public:
    // At most 2^15 samples wide and high.
    explicit BitStamp(const BitRaster& shape);

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    // Sets the samples whose nearest one of the stamp is set, and says how many they are. A few
    // nanoseconds a sample in the stamp's box, 20 a row.
    std::int64_t set_on(BitRaster& raster, const Affine& raster_from_stamp) const;

  private:
    struct Scan;
    std::int64_t set_row(BitRaster& raster, int row, const Scan& scan) const;

    int columns_, rows_;
    std::size_t stride_;                 // samples a row
    std::vector<std::uint8_t> samples_;  // a byte each, a clear one all around
};

}  // namespace edaha
