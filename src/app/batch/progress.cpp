// SPDX-License-Identifier: MIT
#include "app/batch/progress.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/core.h>

namespace edaha {
namespace {

constexpr double kRedrawSeconds = 0.1;
constexpr double kLineSeconds = 5;
constexpr double kRateSeconds = 5;  // shorter, the rate trembles; longer, it lags behind
constexpr std::size_t kMostBar = 30;
constexpr std::size_t kLeastBar = 5;

constexpr const char* kClearLine = "\r\x1b[K";

std::string rate_text(double per_second) {
    return per_second < 9.95 ? fmt::format("{:.1f}/s", per_second)
                             : fmt::format("{:.0f}/s", per_second);
}

std::string figures(const Advance& advance) {
    const std::string total = std::to_string(advance.total);
    std::string text = fmt::format("{:>{}}/{}", advance.done, total.size(), total);
    if (advance.per_second <= 0) return text;
    const auto left = static_cast<double>(advance.total - advance.done) / advance.per_second;
    return text + fmt::format("  {}  {} left", rate_text(advance.per_second), duration_text(left));
}

}  // namespace

std::string duration_text(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::min(seconds, 1e9)));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_line(const Advance& advance, std::size_t columns) {
    const std::string text = figures(advance);
    const std::size_t beside = text.size() + 4;  // brackets and space
    if (columns < beside + kLeastBar) return text.substr(0, columns);
    const std::size_t bar = std::min(kMostBar, columns - beside);
    const std::size_t full = advance.total == 0 ? bar : bar * advance.done / advance.total;
    return '[' + std::string(full, '#') + std::string(bar - full, '-') + "]  " + text;
}

Progress::Progress(std::ostream& out, std::size_t total, std::size_t columns, double now)
    : out_(out), total_(total), columns_(columns), shown_(now), marks_{{now, 0}} {}

void Progress::advance(std::size_t done, double now) {
    if (now - shown_ < (columns_ > 0 ? kRedrawSeconds : kLineSeconds)) return;
    shown_ = now;
    while (marks_.size() > 1 && now - marks_[1].time > kRateSeconds)
        marks_.pop_front();
    const Mark& first = marks_.front();
    const double rate = static_cast<double>(done - first.done) / (now - first.time);
    marks_.push_back({now, done});
    // One column stays free: terminals differ in what a full line does.
    if (columns_ > 0) {
        out_ << kClearLine << progress_line({done, total_, rate}, columns_ - 1) << std::flush;
        visible_ = true;
    } else {
        out_ << "edaha: " << figures({done, total_, rate}) << '\n' << std::flush;
    }
}

void Progress::say(const std::string& line) {
    clear();
    out_ << line << '\n' << std::flush;
}

void Progress::clear() {
    if (visible_) out_ << kClearLine << std::flush;
    visible_ = false;
}

}  // namespace edaha
