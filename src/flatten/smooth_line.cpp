// SPDX-License-Identifier: MIT
#include "flatten/smooth_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "geometry/fit_cubic.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
// Zigzags of contours are about as wide as the mesh's triangles, corners of tips not far apart:
// wider windows round off tips, narrower ones take zigzags for corners.
constexpr double kWindow = 2;
// Nearer to the vertex than this a corner turns by most of what it turns in the window.
constexpr double kCore = 0.5;
constexpr double kSharpTurn = 40 * kDegree;
constexpr double kFlatTurn = 8 * kDegree;
// Closer samples cost time, wider ones let curves bulge between them.
constexpr double kSampleStep = 1.5;
// Of shorter curves nobody sees that they are lines; those have a third of the numbers.
constexpr double kShortestCurve = 3;
// A curve this near its chord is a line.
constexpr double kStraight = 0.02;

double turn_between(Vec2 a, Vec2 b) {
    return std::abs(stable::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
}

double distance_from_chord(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double length2 = glm::dot(d, d);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0;
    return glm::distance(p, a + d * t);
}

// A polyline by its length.
class Polyline {
  public:
    Polyline(std::vector<Vec2> points, bool closed) : points_(std::move(points)), closed_(closed) {
        length_.resize(points_.size());
        for (std::size_t i = 1; i < points_.size(); ++i)
            length_[i] = length_[i - 1] + glm::distance(points_[i - 1], points_[i]);
    }

    std::size_t size() const { return points_.size(); }
    Vec2 operator[](std::size_t i) const { return points_[i]; }
    double length_at(std::size_t i) const { return length_[i]; }
    double length() const { return length_.back(); }
    bool closed() const { return closed_; }

    // Beyond the ends of an open one: the end; closed ones go on round.
    Vec2 at(double s) const {
        if (closed_) s = s < 0 ? s + length() : s > length() ? s - length() : s;
        s = std::clamp(s, 0.0, length());
        const auto after = std::upper_bound(length_.begin() + 1, length_.end() - 1, s);
        const auto i = static_cast<std::size_t>(after - length_.begin());
        const double step = length_[i] - length_[i - 1];
        const double t = step > 0 ? (s - length_[i - 1]) / step : 0;
        return points_[i - 1] + (points_[i] - points_[i - 1]) * std::min(t, 1.0);
    }

  private:
    std::vector<Vec2> points_;
    bool closed_;
    std::vector<double> length_;
};

// Vertices that stick out by more than `noise` (Douglas and Peucker), the first and last included.
std::vector<std::size_t> essential(std::span<const Vec2> points, bool closed, double noise) {
    std::vector<std::uint8_t> keep(points.size(), 0);
    keep.front() = keep.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> spans;
    if (closed) {
        std::size_t far = 0;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            if (glm::distance(points[i], points[0]) > glm::distance(points[far], points[0]))
                far = i;
        }
        keep[far] = 1;
        spans = {{0, far}, {far, points.size() - 1}};
    } else {
        spans = {{0, points.size() - 1}};
    }
    while (!spans.empty()) {
        const auto [a, b] = spans.back();
        spans.pop_back();
        double most = noise;
        std::size_t worst = 0;
        for (std::size_t i = a + 1; i < b; ++i) {
            const double off = distance_from_chord(points[i], points[a], points[b]);
            if (off > most) most = off, worst = i;
        }
        if (worst == 0) continue;
        keep[worst] = 1;
        spans.emplace_back(a, worst);
        spans.emplace_back(worst, b);
    }
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (keep[i]) kept.push_back(i);
    }
    return kept;
}

// How much the line turns within `window` of a place.
double turn_at(const Polyline& line, double s, double window) {
    window = std::min(window, line.length() / 4);  // of small rings not the way round
    const Vec2 p = line.at(s);
    return turn_between(p - line.at(s - window), line.at(s + window) - p);
}

class Smoother {
  public:
    // `kept` are the vertices that count.
    Smoother(std::span<const Vec2> points, std::span<const std::size_t> kept, bool closed,
             const SmoothParams& params)
        : params_(params), line_(chosen(points, kept), closed) {
        source_length_.reserve(kept.size());
        double length = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) length += glm::distance(points[i - 1], points[i]);
            if (kept[source_length_.size()] == i) source_length_.push_back(length);
        }
    }

    std::vector<CurvePiece> smooth() {
        if (params_.straight) {
            for (std::size_t i = 0; i + 1 < line_.size(); ++i)
                add_line(i);
            return std::move(pieces_);
        }
        find_corners();
        find_straight_edges();
        const std::size_t last = line_.size() - 1;
        for (std::size_t from = 0; from < last;) {
            if (straight_[from]) {
                add_line(from++);
                continue;
            }
            std::size_t to = from + 1;
            while (to < last && !corner_[to] && !straight_[to])
                ++to;
            if (line_.length_at(to) - line_.length_at(from) < kShortestCurve) {
                for (; from < to; ++from)
                    add_line(from);
                continue;
            }
            add_curve(from, to);
            from = to;
        }
        return std::move(pieces_);
    }

  private:
    static std::vector<Vec2> chosen(std::span<const Vec2> points,
                                    std::span<const std::size_t> kept) {
        std::vector<Vec2> result;
        result.reserve(kept.size());
        for (const std::size_t i : kept)
            result.push_back(points[i]);
        return result;
    }

    double edge(std::size_t i) const { return line_.length_at(i + 1) - line_.length_at(i); }
    Vec2 way(std::size_t i) const { return line_[i + 1] - line_[i]; }

    void find_corners() {
        const std::size_t last = line_.size() - 1;
        corner_.assign(last + 1, 0);
        turn_.assign(last + 1, 0);
        for (std::size_t i = 0; i <= last; ++i) {
            const bool at_end = i == 0 || i == last;
            if (at_end && !line_.closed()) {
                corner_[i] = 1;
                continue;
            }
            const std::size_t before = at_end ? last - 1 : i - 1, after = at_end ? 0 : i;
            turn_[i] = turn_between(way(before), way(after));
            corner_[i] = is_corner(i, std::min(edge(before), edge(after)));
        }
    }

    // `shorter` is the length of the shorter of its edges.
    bool is_corner(std::size_t i, double shorter) const {
        if (turn_[i] < kFlatTurn) return false;
        const double s = line_.length_at(i);
        const double around = turn_at(line_, s, kWindow);
        if (around < kFlatTurn) return false;
        // A curve through this vertex would be this far from its edges.
        if (shorter * turn_[i] / 8 > params_.tolerance) return true;
        return around > kSharpTurn && turn_at(line_, s, kCore) > 0.6 * around;
    }

    void find_straight_edges() {
        straight_.assign(line_.size() - 1, 0);
        for (std::size_t i = 0; i < straight_.size(); ++i) {
            const double bend =
                std::max(corner_[i] ? 0 : turn_[i], corner_[i + 1] ? 0 : turn_[i + 1]);
            const bool alone = corner_[i] && corner_[i + 1];
            straight_[i] = alone || edge(i) * bend / 8 > params_.tolerance;
        }
    }

    void add_line(std::size_t i) {
        pieces_.push_back({line_cubic(line_[i], line_[i + 1]), true, source_length_[i + 1]});
    }

    // The direction at the start of a curve's span that no line precedes, by the parabola through
    // three of its points.
    Vec2 free_tangent(double from, double to) const {
        const double step = std::copysign(std::min(kWindow, std::abs(to - from) / 2), to - from);
        const Vec2 p = line_.at(from), q = line_.at(from + step), r = line_.at(from + 2 * step);
        const Vec2 tangent = 2.0 * (q - p) - 0.5 * (r - p);
        return step > 0 ? tangent : -tangent;
    }

    Vec2 start_tangent(std::size_t from, std::size_t to) const {
        const std::size_t before = from == 0 ? line_.size() - 2 : from - 1;
        if (!corner_[from] && straight_[before]) return way(before);
        if (!corner_[from]) return seam_tangent();
        return free_tangent(line_.length_at(from), line_.length_at(to));
    }
    Vec2 end_tangent(std::size_t from, std::size_t to) const {
        const std::size_t after = to + 1 == line_.size() ? 0 : to;
        if (!corner_[to] && straight_[after]) return way(after);
        if (!corner_[to]) return seam_tangent();
        return free_tangent(line_.length_at(to), line_.length_at(from));
    }
    Vec2 seam_tangent() const {
        const double window = std::min(kWindow, line_.length() / 4);
        return line_.at(window) - line_.at(-window);
    }

    std::vector<CurveSample> samples(std::size_t from, std::size_t to) const {
        const double begin = line_.length_at(from), end = line_.length_at(to);
        const auto steps = static_cast<int>(std::max(4.0, std::ceil((end - begin) / kSampleStep)));
        std::vector<CurveSample> result{{line_[from], start_tangent(from, to)}};
        for (int i = 1; i < steps; ++i) {
            const double s = begin + (end - begin) * i / steps;
            const double window = std::min({kWindow, s - begin, end - s});
            const Vec2 tangent = line_.at(s + window) - line_.at(s - window);
            // A line that comes back to where it was has no direction there.
            if (glm::dot(tangent, tangent) < 1e-12) continue;
            result.push_back({line_.at(s), tangent});
        }
        result.push_back({line_[to], end_tangent(from, to)});
        return result;
    }

    void add_curve(std::size_t from, std::size_t to) {
        const std::vector<CurveSample> along = samples(from, to);
        const std::vector<Cubic> cubics = fit_cubics(along, params_.tolerance);
        const double begin = source_length_[from], length = source_length_[to] - begin;
        std::size_t i = 0;
        for (std::size_t k = 0; k < cubics.size(); ++k) {
            const Cubic& c = cubics[k];
            while (i + 1 < along.size() && glm::distance(along[i].position, c.p3) > 1e-6)
                ++i;
            const bool last = k + 1 == cubics.size();
            const double share = static_cast<double>(i) / static_cast<double>(along.size() - 1);
            push(c, last ? begin + length : begin + length * share);
        }
    }

    void push(const Cubic& c, double end) {
        const bool straight = distance_from_chord(c.p1, c.p0, c.p3) < kStraight &&
                              distance_from_chord(c.p2, c.p0, c.p3) < kStraight;
        pieces_.push_back({straight ? line_cubic(c.p0, c.p3) : c, straight, end});
    }

    SmoothParams params_;
    Polyline line_;                       // without noise
    std::vector<double> source_length_;   // of the given polyline, at its vertices
    std::vector<double> turn_;            // at a vertex
    std::vector<std::uint8_t> corner_;    // a vertex
    std::vector<std::uint8_t> straight_;  // an edge
    std::vector<CurvePiece> pieces_;
};

}  // namespace

std::vector<CurvePiece> smooth_line(std::span<const Vec2> points, bool closed,
                                    const SmoothParams& params) {
    return Smoother(points, essential(points, closed, params.noise), closed, params).smooth();
}

std::size_t sharpest_vertex(std::span<const Vec2> points) {
    const Polyline line({points.begin(), points.end()}, true);
    std::size_t sharpest = 0;
    double most = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double turn = turn_at(line, line.length_at(i), kWindow);
        if (turn > most + 1e-9) most = turn, sharpest = i;
    }
    return sharpest;
}

}  // namespace edaha
