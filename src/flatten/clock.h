// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "flatten/flatten.h"

namespace edaha {

// Keeps how long each step took, from one to the next.
class StepClock {
  public:
    void end_step(std::string name, std::size_t count, std::string unit) {
        const auto now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        steps_.push_back({std::move(name), seconds, count, std::move(unit)});
        start_ = now;
    }
    std::vector<StepReport> take() { return std::move(steps_); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    std::vector<StepReport> steps_;
};

}  // namespace edaha
