// SPDX-License-Identifier: MIT
#include "flatten/covered_strokes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

// Longer ones are seen to go their own way.
constexpr double kLongest_px = 20;
constexpr double kStep_px = 1;
constexpr double kCell_px = 4;  // more than any line's half width and a step
constexpr std::size_t kWorthThreads = 512;

struct Sample {
    std::uint64_t cell = 0;
    std::uint32_t stroke = 0;
    Vec2 at{0};
};

std::uint64_t cell_of(Vec2 p, int column = 0, int row = 0) {
    const auto index = [](double x) {
        return std::uint64_t(std::int64_t(std::floor(x / kCell_px)) + (1 << 20));
    };
    return (index(p.x) + std::uint64_t(std::int64_t(column))) << 32 |
           (index(p.y) + std::uint64_t(std::int64_t(row)));
}

// Points along a stroke no more than a step apart.
template <typename Visit>
void walk(const ViewStroke& stroke, const Visit& visit) {
    for (const CurvePiece& piece : stroke.pieces) {
        const Cubic& c = piece.curve;
        const double reach =
            glm::distance(c.p0, c.p1) + glm::distance(c.p1, c.p2) + glm::distance(c.p2, c.p3);
        const int steps = static_cast<int>(std::ceil(reach / kStep_px)) + 1;
        for (int i = 0; i <= steps; ++i)
            visit(eval(c, static_cast<double>(i) / steps));
    }
}

double length_of(const ViewStroke& stroke) {
    double length = 0;
    std::optional<Vec2> before;
    walk(stroke, [&](Vec2 p) {
        if (before) length += glm::distance(*before, p);
        before = p;
    });
    return length;
}

class Coverage {
  public:
    Coverage(const std::vector<ViewStroke>& strokes, const FlattenParams& params, double mm_per_px)
        : strokes_(strokes) {
        length_.resize(strokes.size());
        for_each_index(strokes.size(), kWorthThreads,
                       [&](std::size_t i) { length_[i] = length_of(strokes[i]); });
        for (const ViewStroke& stroke : strokes)
            half_width_.push_back(
                std::min(width_mm(params, stroke.kind) / 2 / mm_per_px, kCell_px - kStep_px));
        collect();
    }

    bool is_covered(std::size_t i) const {
        if (length_[i] >= kLongest_px) return false;
        bool covered = true;
        walk(strokes_[i], [&](Vec2 p) { covered = covered && is_near_longer(i, p); });
        return covered;
    }

  private:
    bool is_longer(std::size_t a, std::size_t b) const {
        return length_[a] != length_[b] ? length_[a] > length_[b] : a < b;
    }

    // Samples of all strokes in the cells of short ones and round them.
    void collect() {
        std::vector<std::uint64_t> cells;
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            if (length_[i] >= kLongest_px) continue;
            walk(strokes_[i], [&](Vec2 p) { cells.push_back(cell_of(p)); });
        }
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        samples_ = gather<Sample>(strokes_.size(), [&](std::size_t i, std::vector<Sample>& found) {
            walk(strokes_[i], [&](Vec2 p) {
                for (int column = -1; column <= 1; ++column) {
                    for (int row = -1; row <= 1; ++row) {
                        if (!std::binary_search(cells.begin(), cells.end(),
                                                cell_of(p, column, row)))
                            continue;
                        found.push_back({cell_of(p), static_cast<std::uint32_t>(i), p});
                        return;
                    }
                }
            });
        });
        std::stable_sort(samples_.begin(), samples_.end(),
                         [](const Sample& a, const Sample& b) { return a.cell < b.cell; });
    }

    bool is_near_longer(std::size_t i, Vec2 p) const {
        for (int column = -1; column <= 1; ++column) {
            for (int row = -1; row <= 1; ++row) {
                const std::uint64_t cell = cell_of(p, column, row);
                auto s =
                    std::lower_bound(samples_.begin(), samples_.end(), cell,
                                     [](const Sample& a, std::uint64_t c) { return a.cell < c; });
                for (; s != samples_.end() && s->cell == cell; ++s) {
                    if (is_longer(s->stroke, i) &&
                        glm::distance(s->at, p) <= half_width_[s->stroke] + kStep_px / 2)
                        return true;
                }
            }
        }
        return false;
    }

    const std::vector<ViewStroke>& strokes_;
    std::vector<double> length_, half_width_;  // a stroke: pixels
    std::vector<Sample> samples_;
};

}  // namespace

std::vector<ViewStroke> drop_covered(std::vector<ViewStroke> strokes, const FlattenParams& params,
                                     double mm_per_px) {
    const Coverage coverage(strokes, params, mm_per_px);
    std::vector<std::uint8_t> covered(strokes.size());
    for_each_index(strokes.size(), kWorthThreads,
                   [&](std::size_t i) { covered[i] = coverage.is_covered(i); });
    std::vector<ViewStroke> kept;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!covered[i]) kept.push_back(std::move(strokes[i]));
    }
    return kept;
}

}  // namespace edaha
