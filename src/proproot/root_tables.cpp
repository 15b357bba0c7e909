// SPDX-License-Identifier: MIT
#include "proproot/root_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace edaha {

const RootAge& root_age(int primaries) {
    static constexpr std::array<RootAge, 7> kAges{{{5, 40, 1, 0, 0},
                                                   {8, 60, 1, 0.3, 2},
                                                   {14, 90, 2, 0.8, 3},
                                                   {18, 100, 3, 1.0, 4},
                                                   {30, 110, 4, 1.5, 5},
                                                   {50, 120, 5, 2.0, 5},
                                                   {100, 130, 5, 2.5, 6}}};
    return *std::ranges::find_if(kAges.begin(), kAges.end() - 1, [&](const RootAge& age) {
        return primaries <= age.most_primaries;
    });
}

double highest_primary(const PropRootParams& params, int primaries) {
    if (!(params.highest > 0)) return root_age(primaries).highest;
    return std::max(params.highest, kLowestBranching);
}

Range sag(RootType type) {
    switch (type) {
        case RootType::gentle:
            return {300, 550};
        case RootType::steep:
            return {10, 70};
        case RootType::standard:
            break;
    }
    return {150, 330};
}

double bulge_share(RootType type) {
    switch (type) {
        case RootType::gentle:
            return 0.10;
        case RootType::steep:
            return 0.01;
        case RootType::standard:
            break;
    }
    return 0.05;
}

double slope_factor(double turn_rad) {
    static constexpr std::array<double, kTurnBins> kFactors{1, 2, 4, 6, 8, 10, 15, 20, 25};
    const double bin = std::abs(turn_rad) * kTurnBins / std::numbers::pi;
    return kFactors[std::min(static_cast<std::size_t>(bin), kFactors.size() - 1)];
}

double root_radius(int primaries, unsigned order) {
    double radius = 1 + primaries / 10.0;
    for (; order > 1; --order)
        radius *= 0.8;
    return radius;
}

double trunk_radius(int primaries) {
    return 5 + primaries / 10.0;
}

}  // namespace edaha
