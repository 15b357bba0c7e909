// SPDX-License-Identifier: MIT
#include "flatten/taper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "flatten/arc_curves.h"

namespace edaha {
namespace {

constexpr double kStep_px = 1.5;
constexpr double kMiterLimit = 1.5;
constexpr double kCornerCos = 0.94;  // 20 degrees

Vec2 unit(Vec2 a) {
    const double length = glm::length(a);
    return length > 0 ? a / length : Vec2(0);
}

struct CentrePoint {
    Vec2 at{0};
    Vec2 before{0}, after{0};  // directions
    double length = 0;         // of the line up to here

    bool is_corner() const { return glm::dot(before, after) < kCornerCos; }
};

std::vector<Vec2> points_along(std::span<const CurvePiece> line) {
    std::vector<Vec2> points{line.front().curve.p0};
    for (const CurvePiece& piece : line) {
        const Cubic& c = piece.curve;
        const double reach =
            glm::distance(c.p0, c.p1) + glm::distance(c.p1, c.p2) + glm::distance(c.p2, c.p3);
        const int steps = std::max(2, static_cast<int>(std::ceil(reach / kStep_px)));
        for (int i = 1; i <= steps; ++i) {
            const Vec2 p = i == steps ? c.p3 : eval(c, static_cast<double>(i) / steps);
            if (glm::distance(p, points.back()) > 1e-3) points.push_back(p);
        }
    }
    return points;
}

std::vector<CentrePoint> centre_of(std::span<const CurvePiece> line) {
    const std::vector<Vec2> points = points_along(line);
    std::vector<CentrePoint> centre(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        CentrePoint& c = centre[i];
        c.at = points[i];
        if (i > 0) c.before = unit(points[i] - points[i - 1]);
        if (i + 1 < points.size()) c.after = unit(points[i + 1] - points[i]);
        if (i == 0) c.before = c.after;
        if (i + 1 == points.size()) c.after = c.before;
        if (i > 0) c.length = centre[i - 1].length + glm::distance(points[i], points[i - 1]);
    }
    return centre;
}

// Where one side passes: on the bisector, so that both neighbours have their distance.
Vec2 side_of(const CentrePoint& c, double half_width) {
    const Vec2 along = unit(c.before + c.after);
    const double cosine = std::max(glm::dot(along, c.after), 1 / kMiterLimit);
    return c.at + Vec2(along.y, -along.x) * (half_width / cosine);
}

class Taperer {
  public:
    Taperer(std::span<const CurvePiece> line, const TaperParams& params)
        : params_(params), centre_(centre_of(line)) {
        for (const CentrePoint& c : centre_) {
            if (c.is_corner()) corners_.push_back(c.length);
        }
    }

    double length() const { return centre_.back().length; }

    // One side, the right (1) or left (-1) one, from start to end.
    std::vector<Vec2> side(double sign) const {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < centre_.size(); ++i) {
            const CentrePoint& c = centre_[i];
            const double half = half_width(c.length);
            // Beside a corner the inner side would turn back.
            const bool at_end = i == 0 || i + 1 == centre_.size();
            if (!at_end && !c.is_corner() && corner_distance(c.length) < 2 * half) continue;
            const Vec2 p = side_of(c, sign * half);
            if (points.empty() || glm::distance(p, points.back()) > 1e-3) points.push_back(p);
        }
        return points;
    }

  private:
    double half_width(double s) const {
        const double end = std::min(s, length() - s);
        const double share = params_.taper_px > 0 ? std::min(1.0, end / params_.taper_px) : 1;
        return params_.width_px / 2 * stable::sin_cos(share * std::numbers::pi / 2).sin * width(s);
    }

    // In parts of the line's own.
    double width(double s) const {
        const std::span<const double> widths = params_.widths;
        if (widths.empty()) return 1;
        const double place = length() > 0 ? s / length() * double(widths.size() - 1) : 0;
        const auto i = std::min(static_cast<std::size_t>(place), widths.size() - 1);
        const double next = widths[std::min(i + 1, widths.size() - 1)];
        return widths[i] + (next - widths[i]) * (place - double(i));
    }

    double corner_distance(double s) const {
        const auto after = std::lower_bound(corners_.begin(), corners_.end(), s);
        double least = HUGE_VAL;
        if (after != corners_.end()) least = *after - s;
        if (after != corners_.begin()) least = std::min(least, s - *(after - 1));
        return least;
    }

    TaperParams params_;
    std::vector<CentrePoint> centre_;
    std::vector<double> corners_;  // by length
};

}  // namespace

Path tapered(std::span<const CurvePiece> line, const TaperParams& params,
             const Affine& page_from_px) {
    Path path;
    if (line.empty()) return path;
    const Taperer taperer(line, params);
    if (taperer.length() < 0.1) return path;
    SmoothParams smooth;
    smooth.tolerance = params.tolerance_px;
    smooth.noise = params.tolerance_px / 4;
    std::vector<Vec2> right = taperer.side(1), left = taperer.side(-1);
    std::reverse(left.begin(), left.end());
    if (right.size() < 2 || left.size() < 2) return path;
    append_pieces(path, smooth_line(right, false, smooth), page_from_px);
    append_pieces(path, smooth_line(left, false, smooth), page_from_px);
    if (path.verbs.size() < 3) return {};
    path.close();
    return path;
}

}  // namespace edaha
