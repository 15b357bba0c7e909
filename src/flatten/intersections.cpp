// SPDX-License-Identifier: MIT
#include "flatten/intersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

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

// Through three points.
class Plane {
  public:
    Plane(FinePoint a, FinePoint b, FinePoint c) : a_(a) {
        const std::int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
        const std::int64_t vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
        x_ = uy * vz - uz * vy, y_ = uz * vx - ux * vz, z_ = ux * vy - uy * vx;
    }

    Side side_of(FinePoint p) const {
        const std::int64_t px = p.x - a_.x, py = p.y - a_.y, pz = p.z - a_.z;
        const double volume =
            double(x_) * double(px) + double(y_) * double(py) + double(z_) * double(pz);
        if (std::abs(volume) > kSurely) return {volume, volume > 0};
        const Int128 exact = Int128{x_} * px + Int128{y_} * py + Int128{z_} * pz;
        return {static_cast<double>(exact), exact >= 0};
    }

    // Of a point two steps away, or a little more.
    double volume_near() const {
        constexpr double kTwoSteps = 64;
        return kTwoSteps * (std::abs(double(x_)) + std::abs(double(y_)) + std::abs(double(z_)));
    }

  private:
    FinePoint a_;
    std::int64_t x_, y_, z_;
};

// What two triangles have in common.
struct Meeting {
    std::uint32_t first = 0, second = 0;
    bool flush = false;
    std::optional<ViewSegment> segment;
};

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

    std::optional<Meeting> meet(std::uint32_t first, std::uint32_t second) const {
        const Triangle &s = triangles_[first], &t = triangles_[second];
        for (const std::uint32_t p : s) {
            if (p == t[0] || p == t[1] || p == t[2]) return std::nullopt;
        }
        Meeting meeting{first, second, false, std::nullopt};
        Ends ends;
        if (pierce(s, t, ends, meeting.flush) && pierce(t, s, ends, meeting.flush) &&
            ends.count == 2 && on_screen(ends.at[0]) != on_screen(ends.at[1])) {
            // Surfaces that lie on each other don't show where the hash makes them cross.
            const LineKind kind = meeting.flush ? LineKind::tone : LineKind::intersection;
            meeting.segment = ViewSegment{ends.at[0], ends.at[1], first, second, kind};
        }
        if (!meeting.flush && !meeting.segment) return std::nullopt;
        return meeting;
    }

  private:
    struct Ends {
        std::array<ViewPoint, 2> at;
        std::size_t count = 0;
    };

    // Where the edges of s go through t; false if all of s lies on one side of it. Flush if all of
    // it is close.
    bool pierce(const Triangle& s, const Triangle& t, Ends& ends, bool& flush) const {
        const Plane plane(fine_[t[0]], fine_[t[1]], fine_[t[2]]);
        const std::array<Side, 3> sides{plane.side_of(fine_[s[0]]), plane.side_of(fine_[s[1]]),
                                        plane.side_of(fine_[s[2]])};
        flush = flush || is_flush(plane, sides);
        if (sides[0].above == sides[1].above && sides[1].above == sides[2].above) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            std::size_t from = i, to = (i + 1) % 3;
            if (sides[from].above == sides[to].above) continue;
            if (s[from] > s[to]) std::swap(from, to);
            if (!passes(s[from], s[to], t)) continue;
            if (ends.count < 2)
                ends.at[ends.count] = between(view_.at[s[from]], view_.at[s[to]],
                                              sides[from].volume, sides[to].volume);
            ++ends.count;
        }
        return true;
    }

    static bool is_flush(const Plane& plane, const std::array<Side, 3>& sides) {
        const double near = plane.volume_near();
        return std::abs(sides[0].volume) <= near && std::abs(sides[1].volume) <= near &&
               std::abs(sides[2].volume) <= near;
    }

    // Whether the line p -> q goes by all edges of t on one side.
    bool passes(std::uint32_t p, std::uint32_t q, const Triangle& t) const {
        const bool first = goes_left(p, q, t[0], t[1]);
        return first == goes_left(p, q, t[1], t[2]) && first == goes_left(p, q, t[2], t[0]);
    }
    bool goes_left(std::uint32_t p, std::uint32_t q, std::uint32_t a, std::uint32_t b) const {
        return a < b ? Plane(fine_[p], fine_[q], fine_[a]).side_of(fine_[b]).above
                     : !Plane(fine_[p], fine_[q], fine_[b]).side_of(fine_[a]).above;
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

TriangleBox box_of(const View& view, const Triangle& triangle) {
    TriangleBox box{view.at[triangle[0]], view.at[triangle[0]]};
    for (const std::uint32_t point : {triangle[1], triangle[2]}) {
        const ViewPoint p = view.at[point];
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
    return box;
}

}  // namespace

Crossings intersect_shown(const View& view, const Mesh& mesh) {
    const std::vector<Triangle>& triangles = mesh.triangles;
    std::vector<std::uint32_t> shown;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (view.shown[i]) shown.push_back(i);
    }
    std::vector<TriangleBox> boxes(shown.size());
    for_each_index(shown.size(), 10'000,
                   [&](std::size_t i) { boxes[i] = box_of(view, triangles[shown[i]]); });
    const auto pairs = overlapping_pairs(boxes);
    const PairCutter cutter(view, mesh);
    std::vector<Meeting> meetings = gather<Meeting>(pairs.size(), [&](std::size_t i, auto& found) {
        const auto meeting = cutter.meet(shown[pairs[i][0]], shown[pairs[i][1]]);
        if (meeting) found.push_back(*meeting);
    });
    sort_all(meetings, [](const Meeting& s, const Meeting& t) {
        return s.first != t.first ? s.first < t.first : s.second < t.second;
    });
    Crossings crossings;
    crossings.flush.assign(triangles.size(), 0);
    for (const Meeting& meeting : meetings) {
        if (meeting.flush) crossings.flush[meeting.first] = crossings.flush[meeting.second] = 1;
        if (meeting.segment) crossings.segments.push_back(*meeting.segment);
    }
    return crossings;
}

}  // namespace edaha
