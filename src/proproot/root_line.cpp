// SPDX-License-Identifier: MIT
#include "proproot/root_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "proproot/level_direction.h"

namespace edaha {
namespace {

// Where the first circle of a primary stands, in radii of the trunk from its surface: deep enough
// for a knob as wide as the trunk to begin inside.
constexpr double kInside = 0.6;
// How far apart circles keep, in terms of what their tilt takes.
constexpr double kRoom = 1.15;

class LineMaker {
  public:
    LineMaker(const PropRoot& root, const PropRootParams& params) : root_(root), params_(params) {}

    std::vector<LinePoint> run() {
        std::vector<double> places = bends();
        add_knob(places);
        if (root_.young) add_tip(places);
        std::sort(places.begin(), places.end());
        if (root_.trunk_radius > 0) add_start();
        // Closer than this they say nothing new.
        const double least = 0.05 * root_.radius;
        double last = -least;
        for (const double along : places) {
            if (along < last + least && along < root_.length) continue;
            if (along >= root_.length && root_.length < last + least) line_.pop_back();
            last = std::min(along, root_.length);
            add(last);
            if (last == root_.length) break;
        }
        thin_out();
        return std::move(line_);
    }

  private:
    // Lengths at which the curve has turned by equal steps, both ends among them.
    std::vector<double> bends() const {
        const Catenary& curve = root_.curve;
        const auto angle_at = [&](double x) { return stable::atan2(curve.slope(x), 1); };
        const double first = angle_at(0), last = angle_at(curve.at_length(root_.length));
        const double right_angle = std::numbers::pi / 2;
        const double wanted = params_.curve_points * std::abs(last - first) / right_angle;
        const int steps = std::max(static_cast<int>(std::ceil(wanted)), 3);
        std::vector<double> places{0};
        const auto tangent = [](double angle) {
            const auto [sine, cosine] = stable::sin_cos(angle);
            return sine / cosine;
        };
        for (int i = 1; i < steps; ++i) {
            const double angle = first + (last - first) * i / steps;
            places.push_back(curve.a * (tangent(angle) - tangent(first)));
        }
        places.push_back(root_.length);
        return places;
    }

    void add_knob(std::vector<double>& places) const {
        if (root_.trunk_radius <= 0 || params_.knob <= 0) return;
        for (const double part : {0.4, 0.8, 1.2, 1.7, 2.4})
            places.push_back(std::min(part * kKnobLength * root_.radius, root_.length));
    }

    // A rounded point.
    void add_tip(std::vector<double>& places) const {
        for (const double part : {1.0, 0.7, 0.4, 0.2, 0.07})
            places.push_back(root_.length - part * tip_length(root_));
    }

    void add_start() {
        const double inside = kInside * root_.trunk_radius;
        const Vec3 position = root_.base - level_direction(root_.azimuth_rad) * inside;
        line_.push_back({position, -inside, root_.radius_at(0, params_.knob)});
    }

    void add(double along) {
        line_.push_back({root_.at(along), along, root_.radius_at(along, params_.knob)});
    }

    // How far along the line the circle at i reaches by its tilt, against a chord.
    double reach(std::size_t i) const {
        if (i == 0) return 0;
        const Vec3 before = glm::normalize(line_[i].position - line_[i - 1].position);
        double cosine;
        if (i + 1 < line_.size()) {
            const Vec3 after = glm::normalize(line_[i + 1].position - line_[i].position);
            // Half the bend: tan(b / 2) = sqrt((1 - cos b) / (1 + cos b)).
            const double bend = glm::dot(before, after);
            return line_[i].radius * std::sqrt((1 - bend) / std::max(1 + bend, 1e-6));
        }
        if (root_.young) return 0;
        cosine = std::max(-before.y, 1e-6);  // the last one lies on the ground
        return line_[i].radius * std::sqrt(std::max(1 - cosine * cosine, 0.0)) / cosine;
    }

    void thin_out() {
        for (std::size_t i = 1; i < line_.size() && line_.size() > 2;) {
            const double room = glm::distance(line_[i].position, line_[i - 1].position);
            const double here = reach(i), before = reach(i - 1);
            if (room >= kRoom * (here + before)) {
                ++i;
                continue;
            }
            std::size_t worst = here > before ? i : i - 1;
            if (worst == line_.size() - 1) worst = i - 1;
            if (worst == 0) worst = i;
            if (worst == line_.size() - 1) break;  // nothing between the ends
            line_.erase(line_.begin() + static_cast<std::ptrdiff_t>(worst));
            i = std::max<std::size_t>(worst, 3) - 2;
        }
    }

    const PropRoot& root_;
    const PropRootParams& params_;
    std::vector<LinePoint> line_;
};

}  // namespace

std::vector<LinePoint> root_line(const PropRoot& root, const PropRootParams& params) {
    return LineMaker(root, params).run();
}

}  // namespace edaha
