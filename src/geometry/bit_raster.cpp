// SPDX-License-Identifier: MIT
#include "geometry/bit_raster.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/bezier.h"

namespace edaha {
namespace {

// How many samples of a row of `most` lie before x, or on it.
int samples_before(double x, int most) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(most)) + 0.5);
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
    const auto go_to = [&](Vec2 to) {
        cross(at, to);
        at = to;
    };
    const Vec2* p = path.points.data();
    for (const Verb verb : path.verbs) {
        if (verb == Verb::cubic) {
            const Cubic curve{at, transform(raster_from_path, p[0]),
                              transform(raster_from_path, p[1]), transform(raster_from_path, p[2])};
            const int steps = flatten_steps(curve, tolerance);
            for (int i = 1; i < steps; ++i)
                go_to(eval(curve, static_cast<double>(i) / steps));
            go_to(curve.p3);
            p += 3;
            continue;
        }
        const bool back = verb == Verb::move || verb == Verb::close;
        if (back) go_to(start);
        if (verb == Verb::move) at = start = transform(raster_from_path, *p++);
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

// Rows whose middle lies in (from.y, to.y]: what two segments share at their ends counts once.
void BitRaster::cross(Vec2 from, Vec2 to) {
    const bool down = to.y > from.y;
    const Vec2 high = down ? from : to, low = down ? to : from;
    const int first = samples_before(high.y, rows_), last = samples_before(low.y, rows_);
    if (first >= last) return;
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
      samples_(static_cast<std::size_t>((columns_ + 2) * (rows_ + 2))) {
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column)
            samples_[static_cast<std::size_t>((row + 1) * (columns_ + 2) + column + 1)] =
                shape.at(column, row);
    }
}

// A line through the stamp, from column to column of the raster: place = start + column * step.
struct BitStamp::Scan {
    Vec2 start, step, columns_a_unit;  // the last: 1 / step
};

std::int64_t BitStamp::set_on(BitRaster& raster, const Affine& raster_from_stamp) const {
    const Vec2 a = raster_from_stamp[0], b = raster_from_stamp[1], origin = raster_from_stamp[2];
    const double area = a.x * b.y - a.y * b.x;
    const Vec2 step{b.y / area, -a.y / area};  // in the stamp, for one column of the raster
    const Vec2 fall{-b.x / area, a.x / area};  // and for one row
    // So small a shape that it lies between the samples (or a map that can't be inverted).
    constexpr double kMostStep = 0x1p20;
    if (!(std::max(std::abs(step.x), std::abs(step.y)) < kMostStep)) return 0;
    const double top = origin.y + std::min(a.y * columns_, 0.0) + std::min(b.y * rows_, 0.0);
    const double bottom = origin.y + std::max(a.y * columns_, 0.0) + std::max(b.y * rows_, 0.0);
    const int first = samples_before(top, raster.rows()),
              end = samples_before(bottom, raster.rows());
    Scan scan{step * (0.5 - origin.x) + fall * (first + 0.5 - origin.y), step, 1.0 / step};
    std::int64_t covered = 0;
    for (int row = first; row < end; ++row, scan.start += fall)
        covered += set_row(raster, row, scan);
    return covered;
}

std::int64_t BitStamp::set_row(BitRaster& raster, int row, const Scan& scan) const {
    double from = 0, to = raster.columns() - 1;
    const Vec2 size(columns_, rows_);
    for (int axis = 0; axis < 2; ++axis) {
        // Along the other axis: no column leads in or out, and the infinite ones say so.
        const double s = -scan.start[axis] * scan.columns_a_unit[axis];
        const double t = (size[axis] - scan.start[axis]) * scan.columns_a_unit[axis];
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
    }
    if (!(from <= to)) return 0;
    const int first = static_cast<int>(from) + (from > static_cast<int>(from));
    const int last = static_cast<int>(to);
    // Places in the stamp in 2^-32 samples, from the clear border: stepping is then exact.
    constexpr double kOne = 0x1p32;
    const auto step_x = static_cast<std::int64_t>(scan.step.x * kOne);
    const auto step_y = static_cast<std::int64_t>(scan.step.y * kOne);
    auto x = static_cast<std::int64_t>((scan.start.x + scan.step.x * first + 1) * kOne);
    auto y = static_cast<std::int64_t>((scan.start.y + scan.step.y * first + 1) * kOne);
    const std::int64_t width = columns_ + 2;
    std::int64_t covered = 0;
    for (int column = first; column <= last;) {
        const int end = std::min(last, column | 63);
        const std::size_t word = raster.word(column, row);
        std::uint64_t bits = 0;
        for (; column <= end; ++column, x += step_x, y += step_y) {
            const std::int64_t place = (y >> 32) * width + (x >> 32);
            const std::uint64_t sample = samples_[static_cast<std::size_t>(place)];
            bits |= sample << (column & 63);
            covered += static_cast<std::int64_t>(sample);
        }
        raster.words_[word] |= bits;
    }
    return covered;
}

}  // namespace edaha
