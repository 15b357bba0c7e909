// SPDX-License-Identifier: MIT
#include "flatten/seen_stretches.h"

#include <glm/geometric.hpp>

namespace edaha {
namespace {

constexpr int kHalvings = 6;
// Twigs that hide less of a line than this may be missed.
constexpr double kLook_px = 3;

Vec3 place_on(const SurfaceStep& step, double t) {
    return step.from + (step.to - step.from) * t;
}

class StretchFinder {
  public:
    StretchFinder(const RayScene& rays, std::span<const SurfaceStep> line)
        : rays_(rays), line_(line) {}

    std::vector<SeenStretch> run() {
        for (std::uint32_t i = 0; i < line_.size(); ++i) {
            const SurfaceStep& step = line_[i];
            const double length = glm::distance(Vec2(step.from), Vec2(step.to));
            const int looks = static_cast<int>(length / (kLook_px * kStepsPerPx)) + 1;
            for (int k = 0; k < looks; ++k)
                look(i, double(k) / looks, double(k + 1) / looks);
        }
        end();
        return std::move(found_);
    }

  private:
    void look(std::uint32_t i, double from, double to) {
        // Not on edges, where two triangles are seen.
        const double near_from = from + 0.02 * (to - from);
        const double near_to = to - 0.02 * (to - from);
        const bool start = !is_hidden(i, near_from);
        const bool stop = !is_hidden(i, near_to);
        if (start && stretch_.empty()) add(i, from);
        if (start) add(i, stop ? to : halve(i, near_from, near_to));
        if (!start || !stop) end();
        if (stop && !start) {
            add(i, halve(i, near_to, near_from));
            add(i, to);
        }
    }

    bool is_hidden(std::uint32_t i, double t) const {
        const Vec3 p = place_on(line_[i], t);
        const std::uint32_t own = line_[i].triangle;
        return rays_.is_hidden(Vec2(p), p.z, {own, own});
    }

    // Where between two values of t the line comes out of hiding or goes into it.
    double halve(std::uint32_t i, double shown, double hidden) const {
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = (shown + hidden) / 2;
            (is_hidden(i, middle) ? hidden : shown) = middle;
        }
        return shown;
    }

    void add(std::uint32_t i, double t) { stretch_.push_back({Vec2(place_on(line_[i], t)), i, t}); }
    void end() {
        if (stretch_.size() > 1) found_.push_back(stretch_);
        stretch_.clear();
    }

    const RayScene& rays_;
    std::span<const SurfaceStep> line_;
    SeenStretch stretch_;
    std::vector<SeenStretch> found_;
};

}  // namespace

std::vector<SeenStretch> seen_stretches(const RayScene& rays, std::span<const SurfaceStep> line) {
    return StretchFinder(rays, line).run();
}

}  // namespace edaha
