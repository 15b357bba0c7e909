// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/console.h"
#include "flatten/flatten.h"

namespace edaha {

// Times what is done, step by step.
class Stopwatch {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(from_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point from_ = std::chrono::steady_clock::now();
};

// What --stats tells, a line a step on standard error, and --json.
void print_steps(const std::vector<StepReport>& steps, Console& console);
nlohmann::ordered_json json_of(const std::vector<StepReport>& steps);

}  // namespace edaha
