// SPDX-License-Identifier: MIT
#include "ornament/sprig_clumps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

using glm::dvec3;

// More change nothing that is seen; with fewer, the outermost points remain middles.
constexpr int kRounds = 8;

double square_distance(const dvec3& a, const dvec3& b) {
    return glm::dot(a - b, a - b);
}

dvec3 middle_of(std::span<const dvec3> points) {
    dvec3 sum(0);
    for (const dvec3& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

// The first is the point farthest from all points' middle.
std::vector<dvec3> spread_middles(std::span<const dvec3> points, double radius) {
    std::vector<double> distances;
    const dvec3 middle = middle_of(points);
    for (const dvec3& point : points)
        distances.push_back(square_distance(point, middle));
    std::vector<dvec3> middles;
    for (;;) {
        const auto farthest = std::ranges::max_element(distances);
        if (!middles.empty() && *farthest <= radius * radius) return middles;
        middles.push_back(points[static_cast<std::size_t>(farthest - distances.begin())]);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double distance = square_distance(points[i], middles.back());
            distances[i] = middles.size() == 1 ? distance : std::min(distances[i], distance);
        }
    }
}

std::uint32_t nearest(std::span<const dvec3> middles, const dvec3& point) {
    std::uint32_t best = 0;
    double least = std::numeric_limits<double>::max();
    for (std::uint32_t i = 0; i < middles.size(); ++i) {
        const double distance = square_distance(point, middles[i]);
        if (distance >= least) continue;
        least = distance;
        best = i;
    }
    return best;
}

void assign(Clumps& clumps, std::span<const dvec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        clumps.of_point[i] = nearest(clumps.middles, points[i]);
}

// A clump that has lost all its points stays where it is.
void centre(Clumps& clumps, std::span<const dvec3> points) {
    std::vector<dvec3> sums(clumps.middles.size(), dvec3(0));
    std::vector<double> counts(clumps.middles.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        sums[clumps.of_point[i]] += points[i];
        counts[clumps.of_point[i]] += 1;
    }
    for (std::size_t c = 0; c < sums.size(); ++c) {
        if (counts[c] > 0) clumps.middles[c] = sums[c] / counts[c];
    }
}

std::vector<double> radii_of(const Clumps& clumps, std::span<const dvec3> points) {
    constexpr double kOfBall = 5.0 / 3;  // mean square distance in a ball is 3/5 of its radius'
    std::vector<double> sums(clumps.middles.size(), 0), counts(clumps.middles.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t c = clumps.of_point[i];
        sums[c] += square_distance(points[i], clumps.middles[c]);
        counts[c] += 1;
    }
    for (std::size_t c = 0; c < sums.size(); ++c)
        sums[c] = counts[c] > 0 ? std::sqrt(kOfBall * sums[c] / counts[c]) : 0;
    return sums;
}

}  // namespace

Clumps find_clumps(std::span<const dvec3> points, double radius) {
    Clumps clumps;
    if (points.empty()) return clumps;
    clumps.of_point.resize(points.size());
    clumps.middles = spread_middles(points, std::max(radius, 1e-6));
    for (int round = 0; round < kRounds; ++round) {
        assign(clumps, points);
        centre(clumps, points);
    }
    assign(clumps, points);
    clumps.radii = radii_of(clumps, points);
    return clumps;
}

}  // namespace edaha
