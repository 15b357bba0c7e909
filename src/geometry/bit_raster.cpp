// SPDX-License-Identifier: MIT
#include "geometry/bit_raster.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/common.hpp>

#include "geometry/bezier.h"

namespace edaha {
namespace {

// How many samples of a row of `most` lie before x, or on it.
int samples_before(double x, int most) {
    const double last = std::clamp(x, 0.0, static_cast<double>(most)) + 0.5;  // they lie in middles
    return static_cast<int>(last);
}

int sample_of(std::uint64_t crossing) {
    return static_cast<int>((crossing & 0xffffffff) >> 1);
}

}  // namespace

BitRaster::BitRaster(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      stride_(static_cast<std::size_t>((columns + 63) / 64)),
      words_(stride_ * static_cast<std::size_t>(rows)) {}

std::int64_t BitRaster::count() const {
    std::int64_t count = 0;
    for (const std::uint64_t bits : words_)
        count += std::popcount(bits);
    return count;
}

std::int64_t BitRaster::fill(const Path& path, const Affine& raster_from_path, double tolerance) {
    crossings_.clear();
    Vec2 at(0), start(0);
    int row = 0;  // the first one whose middle lies below `at`: what segments share counts once
    const auto row_below = [&](Vec2 point) { return samples_before(point.y, rows_); };
    const auto go_to = [&](Vec2 to) {
        const int to_row = row_below(to);
        if (to_row != row) cross(at, to, row, to_row);
        at = to;
        row = to_row;
    };
    const Vec2* p = path.points.data();
    for (const Verb verb : path.verbs) {
        if (verb == Verb::cubic) {
            const Cubic curve{at, transform(raster_from_path, p[0]),
                              transform(raster_from_path, p[1]), transform(raster_from_path, p[2])};
            const bool level = row_below(curve.p1) == row && row_below(curve.p2) == row &&
                               row_below(curve.p3) == row;
            const int steps = level ? 1 : flatten_steps(curve, tolerance);
            for (int i = 1; i < steps; ++i)
                go_to(eval(curve, static_cast<double>(i) / steps));
            go_to(curve.p3);
            p += 3;
            continue;
        }
        const bool back = verb == Verb::move || verb == Verb::close;
        if (back) go_to(start);
        if (verb == Verb::move) {
            at = start = transform(raster_from_path, *p++);
            row = row_below(at);
        }
        if (verb == Verb::line) go_to(transform(raster_from_path, *p++));
    }
    go_to(start);
    std::sort(crossings_.begin(), crossings_.end());
    std::int64_t covered = 0;
    int turns = 0;
    for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
        turns += (crossings_[i] & 1) != 0 ? 1 : -1;
        if (turns == 0) continue;  // always where a row ends
        covered += set(static_cast<int>(crossings_[i] >> 32), sample_of(crossings_[i]),
                       sample_of(crossings_[i + 1]));
    }
    return covered;
}

// Rows whose middle lies between the two points: first ones below each, which are not the same.
void BitRaster::cross(Vec2 from, Vec2 to, int from_row, int to_row) {
    const bool down = to_row > from_row;
    const Vec2 high = down ? from : to, low = down ? to : from;
    const int first = down ? from_row : to_row, last = down ? to_row : from_row;
    const double slope = (low.x - high.x) / (low.y - high.y);
    for (int row = first; row < last; ++row) {
        const int before = samples_before(high.x + (row + 0.5 - high.y) * slope, columns_);
        crossings_.push_back(static_cast<std::uint64_t>(row) << 32 |
                             static_cast<std::uint64_t>(before) << 1 | (down ? 1 : 0));
    }
}

std::int64_t BitRaster::set(int row, int first, int end) {
    if (first >= end) return 0;
    const std::size_t first_word = word(first, row), last_word = word(end - 1, row);
    std::uint64_t bits = ~std::uint64_t{0} << (first & 63);
    for (std::size_t i = first_word; i < last_word; ++i) {
        words_[i] |= bits;
        bits = ~std::uint64_t{0};
    }
    words_[last_word] |= bits & ~std::uint64_t{0} >> (63 - ((end - 1) & 63));
    return end - first;
}

BitStamp::BitStamp(const BitRaster& shape)
    : columns_(shape.columns()),
      rows_(shape.rows()),
      stride_(static_cast<std::size_t>(columns_ + 2)),
      samples_(stride_ * static_cast<std::size_t>(rows_ + 2)) {
    for (int row = 0; row < rows_; ++row) {
        const std::uint64_t* const words = &shape.words_[shape.word(0, row)];
        std::uint8_t* const samples = &samples_[static_cast<std::size_t>(row + 1) * stride_ + 1];
        for (int column = 0; column < columns_; ++column)
            samples[column] = words[column >> 6] >> (column & 63) & 1;
    }
}

// A row of the raster as a line through the stamp. Columns of the raster lead in and out across its
// left and right borders (x), and across the upper and lower ones (y).
struct BitStamp::Scan {
    Vec2 start, step;          // the place at column 0 and from column to column, in units
    std::uint64_t step_units;  // the same in one word
    Vec2 in, out;              // at which column
};

namespace {

// Places in the stamp are counted in 2^-16 samples from its clear border, both coordinates in one
// word: while both are in the stamp, one addition is a step.
constexpr double kUnits = 0x1p16;

std::uint64_t word_of(Vec2 units) {
    return (static_cast<std::uint64_t>(static_cast<std::int64_t>(units.y)) << 32) +
           static_cast<std::uint64_t>(static_cast<std::int64_t>(units.x));
}

}  // namespace

inline std::int64_t BitStamp::set_row(BitRaster& raster, int row, const Scan& scan) const {
    const double from = std::max(std::max(scan.in.x, scan.in.y), 0.0);
    const double to = std::min(std::min(scan.out.x, scan.out.y), raster.columns() - 1.0);
    if (!(from <= to)) return 0;
    const int first = static_cast<int>(from) + (from > static_cast<int>(from));
    const int last = static_cast<int>(to);
    std::int64_t covered = 0;
    for (int column = first; column <= last;) {
        const std::size_t word = raster.word(column, row);
        std::uint64_t place = word_of(scan.start + scan.step * static_cast<double>(column));
        std::uint64_t bits = 0;
        const int end = std::min(last, column | 63) + 1;
        for (; column < end; ++column, place += scan.step_units) {
            const std::uint64_t sample =
                samples_[(place >> 48) * stride_ + (static_cast<std::uint32_t>(place) >> 16)];
            bits = std::rotr(bits | sample, 1);
            covered += static_cast<std::int64_t>(sample);
        }
        raster.words_[word] |= std::rotl(bits, end & 63);
    }
    return covered;
}

std::int64_t BitStamp::set_on(BitRaster& raster, const Affine& raster_from_stamp) const {
    const Vec2 a = raster_from_stamp[0], b = raster_from_stamp[1], origin = raster_from_stamp[2];
    const double area = a.x * b.y - a.y * b.x;
    Vec2 step{b.y / area, -a.y / area};        // in the stamp, for one column of the raster
    const Vec2 fall{-b.x / area, a.x / area};  // and for one row
    // So small a shape that it lies between the samples (or a map that can't be inverted).
    constexpr double kMostStep = 0x1p20;
    if (!(std::max(std::abs(step.x), std::abs(step.y)) < kMostStep)) return 0;
    // Along an axis no column leads in or out: so slight a slope makes no difference.
    constexpr double kLeastStep = 0x1p-20;
    if (std::abs(step.x) < kLeastStep) step.x = kLeastStep;
    if (std::abs(step.y) < kLeastStep) step.y = kLeastStep;
    const double top = origin.y + std::min(a.y * columns_, 0.0) + std::min(b.y * rows_, 0.0);
    const double bottom = origin.y + std::max(a.y * columns_, 0.0) + std::max(b.y * rows_, 0.0);
    const int first = samples_before(top, raster.rows()),
              end = samples_before(bottom, raster.rows());
    const Vec2 start = step * (0.5 - origin.x) + fall * (first + 0.5 - origin.y);
    const Vec2 one = -start / step, other = (Vec2(columns_, rows_) - start) / step;
    Scan scan{(start + 1.0) * kUnits, step * kUnits, word_of(step * kUnits), glm::min(one, other),
              glm::max(one, other)};
    const Vec2 fall_units = fall * kUnits, shift = -fall / step;  // the latter in columns
    std::int64_t covered = 0;
    for (int row = first; row < end; ++row) {
        covered += set_row(raster, row, scan);
        scan.start += fall_units;
        scan.in += shift;
        scan.out += shift;
    }
    return covered;
}

}  // namespace edaha
