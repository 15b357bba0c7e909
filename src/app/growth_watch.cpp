// SPDX-License-Identifier: MIT
#include "app/growth_watch.h"

#include <chrono>

#include "app/batch/progress.h"

namespace edaha {
namespace {

// A line that comes and goes at once would only flicker.
constexpr double kQuietSeconds = 1;

}  // namespace

struct GrowthWatch::Line {
    Line(Console& console, std::size_t steps)
        : progress(console.err, steps, console.err_columns, 0) {}

    double now() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    Progress progress;
};

GrowthWatch::GrowthWatch(const Style& style, Console& console) {
    if (console.err_columns == 0 || !has_model(style.models, Model::surface)) return;
    line_ = std::make_unique<Line>(console, static_cast<std::size_t>(style.surface.steps));
}

GrowthWatch::~GrowthWatch() {
    if (line_) line_->progress.clear();
}

SurfaceWatch GrowthWatch::watch() {
    SurfaceWatch watch;
    if (!line_) return watch;
    watch.progress = [this](std::int64_t step, std::size_t) {
        const double now = line_->now();
        if (now > kQuietSeconds) line_->progress.advance(static_cast<std::size_t>(step), now);
    };
    return watch;
}

}  // namespace edaha
