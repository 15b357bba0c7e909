// SPDX-License-Identifier: MIT
#include "support/id_buffer.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace edaha::test {
namespace {

IdBuffer blank(int size) {
    return {size, std::vector<std::uint32_t>(static_cast<std::size_t>(size * size), kNone)};
}

// The middle of pixel i, in steps; half a step aside, so that no point of the grid is met.
double middle(int i, int size) {
    return (i - size / 2) * double(kStepsPerPx) + kStepsPerPx / 2.0 + 0.5;
}

int first_pixel(double steps, int size) {
    const double i = std::ceil((steps - 0.5 - kStepsPerPx / 2.0) / kStepsPerPx) + size / 2;
    return static_cast<int>(std::clamp(i, 0.0, double(size)));
}

class DepthPainter {
  public:
    DepthPainter(const View& view, int size)
        : view_(view),
          buffer_(blank(size)),
          depth_(static_cast<std::size_t>(size * size), HUGE_VAL) {}

    void paint(const Triangle& triangle, std::uint32_t part) {
        std::array<Vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            const ViewPoint at = view_.at[triangle[i]];
            p[i] = {double(at.x), double(at.y), double(at.z)};
        }
        const Vec3 u = p[1] - p[0], v = p[2] - p[0];
        const double area = u.x * v.y - u.y * v.x;
        if (area == 0) return;
        const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
        const int size = buffer_.size;
        for (int y = first_pixel(y0, size); y < first_pixel(y1, size); ++y) {
            const auto [left, right] = span(p, middle(y, size));
            for (int x = first_pixel(left, size); x < first_pixel(right, size); ++x) {
                const double dx = middle(x, size) - p[0].x, dy = middle(y, size) - p[0].y;
                const double b = (dx * v.y - dy * v.x) / area, c = (u.x * dy - u.y * dx) / area;
                put(static_cast<std::size_t>(y * size + x), p[0].z + b * u.z + c * v.z, part);
            }
        }
    }
    IdBuffer take() { return std::move(buffer_); }

  private:
    // Where a row, that meets no corner, cuts a triangle.
    static std::pair<double, double> span(const std::array<Vec3, 3>& p, double y) {
        double left = HUGE_VAL, right = -HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = p[i], b = p[(i + 1) % 3];
            if ((a.y < y) == (b.y < y)) continue;
            const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            left = std::min(left, x), right = std::max(right, x);
        }
        return {left, right};
    }

    // A step's difference is a tie.
    void put(std::size_t pixel, double z, std::uint32_t part) {
        const bool tie = std::abs(z - depth_[pixel]) <= 1;
        if (tie ? part >= buffer_.part[pixel] : z > depth_[pixel]) return;
        depth_[pixel] = z;
        buffer_.part[pixel] = part;
    }

    const View& view_;
    IdBuffer buffer_;
    std::vector<double> depth_;
};

// Whether the part is anywhere in the pixel or so many pixels round it.
bool is_within(const IdBuffer& fine, int x, int y, int reach, std::uint32_t part) {
    for (int fy = kFine * (y - reach); fy < kFine * (y + reach + 1); ++fy) {
        for (int fx = kFine * (x - reach); fx < kFine * (x + reach + 1); ++fx) {
            if (fine.at(fx, fy) == part) return true;
        }
    }
    return false;
}

}  // namespace

IdBuffer paint_depth(const Mesh& mesh, const View& view, int size) {
    DepthPainter painter(view, size);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        painter.paint(mesh.triangles[i], mesh.part_of[i]);
    return painter.take();
}

IdBuffer paint_map(const LabelledMap& map, int size) {
    IdBuffer buffer = blank(size);
    std::vector<std::vector<std::pair<double, std::uint32_t>>> crossings(
        static_cast<std::size_t>(size));
    for (std::uint32_t h = 0; h < map.map.next.size(); ++h) {
        const Vec2 a = to_vec(map.map.nodes[map.map.origin(h)]);
        const Vec2 b = to_vec(map.map.nodes[map.map.target(h)]);
        if (a.y <= b.y) continue;  // of two half-edges the one whose left is at greater x
        for (int y = first_pixel(b.y, size); y < first_pixel(a.y, size); ++y) {
            const double x = a.x + (b.x - a.x) * (middle(y, size) - a.y) / (b.y - a.y);
            crossings[static_cast<std::size_t>(y)].emplace_back(x, map.map.face_of(h));
        }
    }
    for (int y = 0; y < size; ++y) {
        auto& row = crossings[static_cast<std::size_t>(y)];
        std::stable_sort(row.begin(), row.end(),
                         [](const auto& s, const auto& t) { return s.first < t.first; });
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            const int end = first_pixel(row[i + 1].first, size);
            for (int x = first_pixel(row[i].first, size); x < end; ++x)
                buffer.part[static_cast<std::size_t>(y * size + x)] =
                    map.labels[row[i].second].part;
        }
    }
    return buffer;
}

Disagreement compare(const IdBuffer& truth, const IdBuffer& fine, const IdBuffer& other) {
    Disagreement result;
    for (int y = 0; y < truth.size; ++y) {
        for (int x = 0; x < truth.size; ++x) {
            const std::uint32_t part = truth.at(x, y);
            if (part != kNone) ++result.covered;
            if (part == other.at(x, y)) continue;
            ++result.differ;
            if (!is_within(fine, x, y, 1, other.at(x, y))) ++result.far;
            if (!is_within(fine, x, y, 2, other.at(x, y))) ++result.very_far;
        }
    }
    return result;
}

}  // namespace edaha::test
