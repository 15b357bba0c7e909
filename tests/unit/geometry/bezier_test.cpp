// SPDX-License-Identifier: MIT
#include "geometry/bezier.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "shapes.h"

namespace edaha {
namespace {

Cubic any_cubic(shapes::Random& random) {
    const auto point = [&] { return Vec2(random(), random()); };
    return {point(), point(), point(), point()};
}

double distance_to_chord(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double t = glm::dot(p - a, along) / glm::dot(along, along);
    return glm::distance(p, a + along * std::min(1.0, std::max(0.0, t)));
}

TEST(Cubic, DerivativeIsTheSlope) {
    shapes::Random random;
    const Cubic c = any_cubic(random);
    for (const double t : {0.1, 0.5, 0.8}) {
        const Vec2 slope = (eval(c, t + 1e-5) - eval(c, t - 1e-5)) / 2e-5;
        EXPECT_NEAR(glm::distance(slope, derivative(c, t)), 0, 1e-8);
    }
}

TEST(Cubic, PartsRunOnTheWhole) {
    shapes::Random random;
    for (int round = 0; round < 50; ++round) {
        const Cubic c = any_cubic(random);
        const double t0 = random(), t1 = random();
        const Cubic part = sub_cubic(c, t0, t1);
        for (const double t : {0.0, 0.3, 1.0}) {
            EXPECT_NEAR(glm::distance(eval(part, t), eval(c, t0 + t * (t1 - t0))), 0, 1e-12);
        }
    }
}

TEST(Cubic, PartsKeepTheEndsToTheLastBit) {
    const Cubic c{{0.1, 0.2}, {0.7, 0.3}, {0.9, 1.1}, {1.3, 0.7}};
    EXPECT_EQ(sub_cubic(c, 0, 0.3).p0, c.p0);
    EXPECT_EQ(sub_cubic(c, 0.3, 1).p3, c.p3);
    EXPECT_EQ(sub_cubic(c, 1, 0).p0, c.p3);
    const auto [first, second] = split(c, 0.37);
    EXPECT_EQ(first.p3, second.p0);
}

TEST(Cubic, FlattenedStaysWithinTheTolerance) {
    shapes::Random random;
    for (int round = 0; round < 100; ++round) {
        const Cubic c = any_cubic(random);
        const double tolerance = 1e-3;
        const auto points = flatten(c, tolerance);
        const auto steps = static_cast<int>(points.size()) - 1;
        for (int i = 0; i < steps; ++i) {
            const Vec2 middle = eval(c, (i + 0.5) / steps);
            EXPECT_LE(distance_to_chord(middle, points[i], points[i + 1]), tolerance);
        }
    }
}

TEST(Cubic, StraightOneFlattensToItsEnds) {
    const Cubic line{{0, 0}, {1, 1}, {2, 2}, {3, 3}};
    EXPECT_EQ(flatten(line, 1e-6).size(), 2u);
}

TEST(Cubic, ArcLengthOfStraightAndRound) {
    EXPECT_NEAR(arc_length({{0, 0}, {1, 0}, {2, 0}, {3, 4}}),
                arc_length({{3, 4}, {2, 0}, {1, 0}, {0, 0}}), 1e-9);
    EXPECT_NEAR(arc_length({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), 3 * std::sqrt(2.0), 1e-12);
    // A parabola y = x^2 on [0, 1], raised to a cubic: (2 sqrt 5 + asinh 2) / 4.
    EXPECT_NEAR(arc_length({{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1}}),
                (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4, 1e-8);
}

}  // namespace
}  // namespace edaha
