// SPDX-License-Identifier: MIT
#include "app/step_times.h"

#include <cmath>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace edaha {

void print_steps(const std::vector<StepReport>& steps, Console& console) {
    for (const StepReport& step : steps) {
        console.err << fmt::format("{:<14} {:8.3f} s {:>10} {}\n", step.name, step.seconds,
                                   step.count, step.unit);
    }
}

nlohmann::ordered_json json_of(const std::vector<StepReport>& steps) {
    auto json = nlohmann::ordered_json::array();
    for (const StepReport& step : steps) {
        json.push_back({{"name", step.name},
                        {"seconds", std::round(step.seconds * 1e6) / 1e6},
                        {"count", step.count},
                        {"unit", step.unit}});
    }
    return json;
}

}  // namespace edaha
