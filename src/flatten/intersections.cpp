// SPDX-License-Identifier: MIT
#include "flatten/intersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/keyed_random.h"
#include "base/parallel.h"
#include "flatten/box_pairs.h"

namespace edaha {
namespace {

// A view's point on a grid 32 times as fine, moved within its old cell by a hash of its part and
// place: so four points lie in one plane, or two parts' points in one place, only by rare chance,
// and whether an edge pierces a triangle is told alike by all who share one of them.
struct FinePoint {
    std::int64_t x = 0, y = 0, z = 0;
};

FinePoint moved_aside(ViewPoint p, std::uint32_t part) {
    Key key = step(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y));
    key = step(step(key, static_cast<std::uint32_t>(p.z)), part);
    const auto fine = [&key](std::int32_t coordinate) {
        const auto aside = static_cast<std::int64_t>(key & 31U) - 16;
        key >>= 5;
        return std::int64_t{32} * coordinate + aside;
    };
    return {fine(p.x), fine(p.y), fine(p.z)};
}

// Six times the volume of the tetrahedron abcp, rounded; its sign is exact, 0 counting as positive.
struct Side {
    double volume = 0;
    bool above = true;
};

// Coordinates differ by less than 2^30, so the error of the sum of products in doubles is below.
constexpr double kSurely = double(std::int64_t{1} << 42);

Side side_of(FinePoint a, FinePoint b, FinePoint c, FinePoint p) {
    const std::int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const std::int64_t vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const std::int64_t px = p.x - a.x, py = p.y - a.y, pz = p.z - a.z;
    const std::int64_t nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double volume =
        double(nx) * double(px) + double(ny) * double(py) + double(nz) * double(pz);
    if (std::abs(volume) > kSurely) return {volume, volume > 0};
    const Int128 exact = Int128{nx} * px + Int128{ny} * py + Int128{nz} * pz;
    return {static_cast<double>(exact), exact >= 0};
}

class PairCutter {
  public:
    PairCutter(const View& view, const Mesh& mesh)
        : view_(view), triangles_(mesh.triangles), fine_(view.at.size()) {
        std::vector<std::uint32_t> part(fine_.size(), 0);
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            for (const std::uint32_t point : triangles_[i])
                part[point] = mesh.part_of[i];
        }
        for_each_index(fine_.size(), 20'000,
                       [&](std::size_t i) { fine_[i] = moved_aside(view.at[i], part[i]); });
    }

    std::optional<ViewSegment> cut(std::uint32_t first, std::uint32_t second) const {
        const Triangle &s = triangles_[first], &t = triangles_[second];
        for (const std::uint32_t p : s) {
            if (p == t[0] || p == t[1] || p == t[2]) return std::nullopt;
        }
        std::array<ViewPoint, 2> ends;
        int found = 0;
        if (!pierce(s, t, ends, found) || !pierce(t, s, ends, found)) return std::nullopt;
        if (found != 2 || on_screen(ends[0]) == on_screen(ends[1])) return std::nullopt;
        // Surfaces that lie on each other don't show where the hash makes them cross.
        const LineKind kind = is_flush(s, t) ? LineKind::tone : LineKind::intersection;
        return ViewSegment{ends[0], ends[1], first, second, kind};
    }

  private:
    FinePoint at(std::uint32_t point) const { return fine_[point]; }

    // Whether all of s is within a step of the plane of t.
    bool is_flush(const Triangle& s, const Triangle& t) const {
        const auto place = [this](std::uint32_t point) {
            const ViewPoint p = view_.at[point];
            return Vec3(p.x, p.y, p.z);
        };
        const Vec3 a = place(t[0]);
        const Vec3 normal = glm::cross(place(t[1]) - a, place(t[2]) - a);
        const double length = glm::length(normal);
        return std::all_of(s.begin(), s.end(), [&](std::uint32_t point) {
            return std::abs(glm::dot(place(point) - a, normal)) <= length;
        });
    }

    // Where the edges of s go through t; false if all of s lies on one side of it.
    bool pierce(const Triangle& s, const Triangle& t, std::array<ViewPoint, 2>& ends,
                int& found) const {
        std::array<Side, 3> sides;
        for (std::size_t i = 0; i < 3; ++i)
            sides[i] = side_of(at(t[0]), at(t[1]), at(t[2]), at(s[i]));
        if (sides[0].above == sides[1].above && sides[1].above == sides[2].above) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            std::size_t from = i, to = (i + 1) % 3;
            if (sides[from].above == sides[to].above) continue;
            if (s[from] > s[to]) std::swap(from, to);
            if (!passes(s[from], s[to], t)) continue;
            if (found < 2)
                ends[static_cast<std::size_t>(found)] = between(
                    view_.at[s[from]], view_.at[s[to]], sides[from].volume, sides[to].volume);
            ++found;
        }
        return true;
    }

    // Whether the line p -> q goes by all edges of t on one side.
    bool passes(std::uint32_t p, std::uint32_t q, const Triangle& t) const {
        const bool first = goes_left(p, q, t[0], t[1]);
        return first == goes_left(p, q, t[1], t[2]) && first == goes_left(p, q, t[2], t[0]);
    }
    bool goes_left(std::uint32_t p, std::uint32_t q, std::uint32_t a, std::uint32_t b) const {
        return a < b ? side_of(at(p), at(q), at(a), at(b)).above
                     : !side_of(at(p), at(q), at(b), at(a)).above;
    }

    static ViewPoint between(ViewPoint p, ViewPoint q, double at_p, double at_q) {
        const double t = at_p / (at_p - at_q);
        const auto place = [t](std::int32_t from, std::int32_t to) {
            const double value = from + t * (double(to) - from);
            return static_cast<std::int32_t>(std::floor(value + 0.5));
        };
        return {place(p.x, q.x), place(p.y, q.y), place(p.z, q.z)};
    }

    const View& view_;
    std::span<const Triangle> triangles_;
    std::vector<FinePoint> fine_;
};

ViewBox box_of(const View& view, const Triangle& triangle) {
    ViewBox box{{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};
    for (const std::uint32_t point : triangle) {
        const ViewPoint p = view.at[point];
        const std::array<float, 3> place{float(p.x), float(p.y), float(p.z)};
        for (std::size_t i = 0; i < 3; ++i) {
            box.min[i] = std::min(box.min[i], place[i]);
            box.max[i] = std::max(box.max[i], place[i]);
        }
    }
    return box;
}

}  // namespace

std::vector<ViewSegment> intersect_shown(const View& view, const Mesh& mesh) {
    const std::vector<Triangle>& triangles = mesh.triangles;
    std::vector<std::uint32_t> shown;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (view.shown[i]) shown.push_back(i);
    }
    std::vector<ViewBox> boxes(shown.size());
    for_each_index(shown.size(), 10'000,
                   [&](std::size_t i) { boxes[i] = box_of(view, triangles[shown[i]]); });
    const auto pairs = overlapping_pairs(boxes);
    const PairCutter cutter(view, mesh);
    std::vector<ViewSegment> segments =
        gather<ViewSegment>(pairs.size(), [&](std::size_t i, auto& found) {
            const auto segment = cutter.cut(shown[pairs[i][0]], shown[pairs[i][1]]);
            if (segment) found.push_back(*segment);
        });
    std::sort(segments.begin(), segments.end(), [](const ViewSegment& s, const ViewSegment& t) {
        return s.triangle != t.triangle ? s.triangle < t.triangle : s.other < t.other;
    });
    return segments;
}

}  // namespace edaha
