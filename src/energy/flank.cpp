// SPDX-License-Identifier: MIT
#include "energy/flank.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

// Limbs above this half width are checked at twice as many places: the inner side of a bend may
// turn sharply there.
constexpr double kThickHalfWidth = 0.6;
// Pieces are not halved below this part of the limb's half width: what is left is a cusp.
constexpr double kShortestPiece = 0.1;

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// The cubic with the end tangents of the samples, evenly spaced, through the middle one; if its
// arms are sound and it stays near the others.
std::optional<Cubic> through_middle(std::span<const CurveSample> samples, double tolerance) {
    const CurveSample &first = samples.front(), &last = samples.back();
    const double chord = glm::distance(first.position, last.position);
    const double first_length = glm::length(first.tangent), last_length = glm::length(last.tangent);
    if (chord < 1e-9 || first_length == 0 || last_length == 0) return std::nullopt;
    const Vec2 t0 = first.tangent / first_length, t1 = last.tangent / last_length;
    // The middle of a cubic is (p0 + 3 p1 + 3 p2 + p3) / 8: two equations for the two arms.
    const std::size_t steps = samples.size() - 1;
    const Vec2 lift =
        (samples[steps / 2].position - (first.position + last.position) * 0.5) * (8.0 / 3);
    const double turn = cross(t0, t1);
    double a = chord / 3, b = chord / 3;
    if (std::abs(turn) > 0.02) a = cross(lift, t1) / turn, b = cross(lift, t0) / turn;
    // Shorter arms make a corner, longer ones a loop.
    const auto sound = [&](double arm) { return arm > 0.1 * chord && arm < 0.7 * chord; };
    if (!sound(a) || !sound(b)) return std::nullopt;
    const Cubic cubic{first.position, first.position + t0 * a, last.position - t1 * b,
                      last.position};
    for (std::size_t i = 1; i < steps; ++i) {
        const CurveSample& sample = samples[i];
        const double t = static_cast<double>(i) / static_cast<double>(steps);
        const double off = cross(sample.tangent, eval(cubic, t) - sample.position);
        const double length2 = glm::dot(sample.tangent, sample.tangent);
        if (length2 == 0 || off * off > tolerance * tolerance * length2) return std::nullopt;
    }
    return cubic;
}

class FlankFitter {
  public:
    FlankFitter(const LimbCurve& curve, double across, LimbPlace from)
        : curve_(curve), across_(across), length_(curve.length_mm(0, curve.spans())) {
        start_ = curve.length_mm(0, from.span) + from.t * curve.chord_mm(from.span);
        half_width_ = curve.slice(from).half_width;
        tolerance_ = flank_tolerance_mm(half_width_);
        steps_ = half_width_ > kThickHalfWidth ? 8 : 4;
        cubics_.reserve(8);  // as many as most limbs have
    }

    std::vector<Cubic> run() {
        Samples samples;
        for (std::size_t i = 0; i <= steps_; ++i)
            samples[i] = sample(start_, length_, i);
        fit(start_, length_, samples);
        return std::move(cubics_);
    }

  private:
    using Samples = std::array<CurveSample, 9>;

    // The i-th of the evenly spaced samples from chord length a to b.
    CurveSample sample(double a, double b, std::size_t i) const {
        const double s = a + (b - a) * static_cast<double>(i) / static_cast<double>(steps_);
        return curve_.section(curve_.walk(0, s)).sample(across_);
    }

    void fit(double a, double b, const Samples& samples) {
        const std::span used(samples.data(), steps_ + 1);
        if (const auto cubic = through_middle(used, tolerance_)) {
            add(*cubic);
        } else if (b - a > kShortestPiece * half_width_) {
            const double middle = (a + b) / 2;
            fit(a, middle, between(a, middle, samples, 0));
            fit(middle, b, between(middle, b, samples, steps_ / 2));
        } else {
            const Vec2 p0 = used.front().position, p1 = used.back().position;
            add({p0, p0 + (p1 - p0) / 3.0, p1 - (p1 - p0) / 3.0, p1});
        }
    }

    // The samples of one half: every other one is known.
    Samples between(double a, double b, const Samples& known, std::size_t first) const {
        Samples samples;
        for (std::size_t i = 0; i <= steps_; ++i) {
            samples[i] = i % 2 == 0 ? known[first + i / 2] : sample(a, b, i);
        }
        return samples;
    }

    void add(Cubic cubic) {
        if (!cubics_.empty()) cubic.p0 = cubics_.back().p3;
        if (glm::distance(cubic.p0, cubic.p3) > 1e-4) cubics_.push_back(cubic);
    }

    const LimbCurve& curve_;
    double across_;
    double length_;
    double start_ = 0;
    double half_width_ = 0;
    double tolerance_ = 0;
    std::size_t steps_ = 4;
    std::vector<Cubic> cubics_;
};

}  // namespace

double flank_tolerance_mm(double half_width) {
    return std::clamp(half_width / 15, 0.008, 0.05);
}

std::vector<Cubic> fit_flank(const LimbCurve& curve, double across, LimbPlace from) {
    return FlankFitter(curve, across, from).run();
}

}  // namespace edaha
