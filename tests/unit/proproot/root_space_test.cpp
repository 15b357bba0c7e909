// SPDX-License-Identifier: MIT
#include "proproot/root_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "proproot/root_tables.h"

namespace edaha::test {
namespace {

LinePoint between(const LinePoint& a, const LinePoint& b, double t) {
    return {a.position + (b.position - a.position) * t, a.along + (b.along - a.along) * t,
            a.radius + (b.radius - a.radius) * t};
}

// The least of a function on [0, 1] that falls and then rises, by thirds.
template <typename Function>
double least(const Function& function) {
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (function(a) < function(b) ? high : low) = function(a) < function(b) ? b : a;
    }
    return function((low + high) / 2);
}

using Chord = std::array<LinePoint, 2>;

// Distance less radii. The distance of two points on two segments is convex in both places, and
// the radii are linear in them, so the least lies where nested searches find it.
double gap(const Chord& p, const Chord& q) {
    return least([&](double s) {
        const LinePoint a = between(p[0], p[1], s);
        return least([&](double t) {
            const LinePoint b = between(q[0], q[1], t);
            return glm::distance(a.position, b.position) - a.radius - b.radius;
        });
    });
}

bool surely_apart(const Chord& p, const Chord& q) {
    const double reach = std::max(p[0].radius, p[1].radius) + std::max(q[0].radius, q[1].radius);
    for (int k = 0; k < 3; ++k) {
        const auto [p_low, p_high] = std::minmax(p[0].position[k], p[1].position[k]);
        const auto [q_low, q_high] = std::minmax(q[0].position[k], q[1].position[k]);
        if (p_low > q_high + reach || q_low > p_high + reach) return true;
    }
    return false;
}

struct Body {
    std::vector<LinePoint> line;
    std::int32_t self, parent;
    double joint;
};

std::vector<Chord> chords(const Body& body, bool beyond_joint) {
    std::vector<Chord> result;
    for (std::size_t i = 1; i < body.line.size(); ++i) {
        Chord chord{body.line[i - 1], body.line[i]};
        if (beyond_joint) {
            if (chord[1].along <= body.joint) continue;
            const double t = (body.joint - chord[0].along) / (chord[1].along - chord[0].along);
            if (t > 0) chord[0] = between(chord[0], chord[1], t);
        }
        result.push_back(chord);
    }
    return result;
}

double least_gap(const Body& a, bool a_beyond, const Body& b, bool b_beyond) {
    double result = 1e9;
    for (const Chord& p : chords(a, a_beyond))
        for (const Chord& q : chords(b, b_beyond))
            if (!surely_apart(p, q)) result = std::min(result, gap(p, q));
    return result;
}

double least_gap(const Body& a, const Body& b) {
    if (a.parent == b.self) return least_gap(a, true, b, false);
    if (b.parent == a.self) return least_gap(a, false, b, true);
    if (a.parent == b.parent)
        return std::min(least_gap(a, true, b, false), least_gap(a, false, b, true));
    return least_gap(a, false, b, false);
}

std::vector<Body> bodies(const PropRoots& plant, const PropRootParams& params) {
    std::vector<Body> result;
    for (std::size_t i = 0; i < plant.roots.size(); ++i) {
        const PropRoot& root = plant.roots[i];
        const double parent = root.parent < 0
                                  ? root.trunk_radius
                                  : plant.roots[static_cast<std::size_t>(root.parent)].radius;
        result.push_back({root_line(root, params), static_cast<std::int32_t>(i), root.parent,
                          joint_length(root.radius, parent)});
    }
    Body trunk{{}, -1, -2, 0};
    for (const double part : {0.0, 0.25, 0.5, 0.75, 0.83}) {
        const double y = part * plant.trunk.height;
        trunk.line.push_back({plant.trunk.centre(y), y, 0.98 * plant.trunk.radius(y)});
    }
    result.push_back(trunk);
    return result;
}

double worst(const PropRootParams& params, std::uint64_t seed) {
    const PropRoots plant = grow_prop_roots(params, KeyedRandom(1, seed, 1));
    const std::vector<Body> all = bodies(plant, params);
    double result = 1e9;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            result = std::min(result, least_gap(all[i], all[j]));
    return result;
}

TEST(RootSpace, NoTwoRootsPassThroughEachOther) {
    PropRootParams params;
    params.primaries = 49;
    EXPECT_GT(worst(params, 1), -1e-6);
    params.primaries = 25;
    params.type = RootType::steep;
    EXPECT_GT(worst(params, 2), -1e-6);
    params.type = RootType::gentle;
    EXPECT_GT(worst(params, 3), -1e-6);
    params.apart = false;
    EXPECT_LT(worst(params, 3), -1);
}

TEST(RootSpace, FindsWhatALineRunsInto) {
    RootSpace space(16);
    const std::vector<LinePoint> standing{{{0, 10, 0}, 0, 2}, {{100, 10, 0}, 100, 2}};
    space.add(standing, {0, -1, 10});
    const auto crossing = [&](double height, const RootBody& body) {
        const std::vector<LinePoint> line{{{50, height, -40}, 0, 1}, {{50, height, 40}, 80, 1}};
        return !space.free(line, body);
    };
    const RootBody stranger{7, 3, 10};
    EXPECT_TRUE(crossing(12.9, stranger));
    EXPECT_FALSE(crossing(13.1, stranger));
    EXPECT_TRUE(crossing(7.1, stranger));
    // 40 along it, the crossing lies within a joint of 50.
    EXPECT_FALSE(crossing(10, {7, 0, 50}));
    EXPECT_TRUE(crossing(10, {7, 0, 30}));
    // Both children of the trunk: 50 along the one that stands is beyond its joint of 10.
    EXPECT_TRUE(crossing(10, {7, -1, 60}));
}

}  // namespace
}  // namespace edaha::test
