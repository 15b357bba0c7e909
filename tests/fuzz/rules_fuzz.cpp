// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "surface/rules.h"

namespace {

using namespace edaha;

constexpr std::int64_t kSteps = 20;
// Buds of buds grow without end: only the first ones are followed.
constexpr std::size_t kMostApices = 16;

void require(bool holds) {
    if (!holds) std::abort();
}

// What growth relies on.
void require_sound(const ApexState& apex) {
    require(std::isfinite(apex.speed_mm) && apex.speed_mm >= 0);
    require(std::isfinite(apex.thickening_mm) && apex.thickening_mm >= 0);
    for (int i = 0; i < 3; ++i)
        require(std::abs(glm::length(apex.frame[i]) - 1) < 1e-6);
    require(std::abs(glm::dot(apex.frame[0], apex.frame[1])) < 1e-6);
}

void grow(const Rules& rules) {
    const KeyedRandom random(1, 1, 1);
    std::vector<ApexState> apices{first_apex(rules, 60, 3)};
    for (std::int64_t step = 1; step <= kSteps; ++step) {
        const std::size_t growing = apices.size();
        for (std::size_t i = 0; i < growing; ++i) {
            if (apices[i].stopped) continue;
            const std::vector<Bud> buds = advance(rules, apices[i], random, step);
            require_sound(apices[i]);
            for (const Bud& bud : buds) {
                require(bud.delay >= 0 && std::abs(glm::length(bud.direction) - 1) < 1e-6);
                if (apices.size() < kMostApices) apices.push_back(bud.state);
            }
        }
    }
}

}  // namespace

// Any text is refused with a place for each problem, or gives rules that drive apices whose frames
// stay square and whose speeds are finite, until a value of theirs is none and is refused as well.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    // Places count lone carriage returns as line ends too.
    const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
    const int lines = 1 + static_cast<int>(std::ranges::count_if(text, is_end));
    try {
        grow(*parse_rules(text, "rules"));
    } catch (const InputError& error) {
        require(!error.problems().empty());
        for (const Problem& problem : error.problems())
            require(problem.place.line >= 1 && problem.place.line <= lines);
    }
    return 0;
}
