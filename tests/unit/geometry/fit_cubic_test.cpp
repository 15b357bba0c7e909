// SPDX-License-Identifier: MIT
#include "geometry/fit_cubic.h"

#include <functional>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "shapes.h"

namespace edaha {
namespace {

using Curve = std::function<CurveSample(double)>;

std::vector<CurveSample> sampled(const Curve& curve, int count) {
    std::vector<CurveSample> samples;
    for (int i = 0; i < count; ++i)
        samples.push_back(curve(static_cast<double>(i) / (count - 1)));
    return samples;
}

Curve arc(double radius, double turn) {
    return [=](double u) {
        const double a = u * turn;
        return CurveSample{{radius * std::cos(a), radius * std::sin(a)},
                           {-std::sin(a), std::cos(a)}};
    };
}

Curve sine(double waves) {
    return [=](double u) {
        const double x = u * waves * 2 * shapes::kPi;
        return CurveSample{{20 * x, 30 * std::sin(x)}, {20, 30 * std::cos(x)}};
    };
}

// Distance to the cubics' finely cut polyline: knows nothing of parameters or normals.
double distance(Vec2 p, const std::vector<Cubic>& cubics) {
    double nearest = 1e300;
    for (const Cubic& c : cubics) {
        Vec2 a = c.p0;
        for (int i = 1; i <= 2000; ++i) {
            const Vec2 b = eval(c, i / 2000.0);
            const double t = glm::dot(p - a, b - a) / std::max(glm::dot(b - a, b - a), 1e-300);
            nearest = std::min(nearest, glm::distance(p, a + (b - a) * std::clamp(t, 0.0, 1.0)));
            a = b;
        }
    }
    return nearest;
}

void expect_close_and_smooth(const std::vector<CurveSample>& samples,
                             const std::vector<Cubic>& cubics, double tolerance) {
    for (const CurveSample& sample : samples) {
        EXPECT_LE(distance(sample.position, cubics), tolerance * 1.001 + 1e-5);
    }
    EXPECT_EQ(cubics.front().p0, samples.front().position);
    EXPECT_NEAR(glm::distance(cubics.back().p3, samples.back().position), 0, 1e-12);
    for (std::size_t i = 1; i < cubics.size(); ++i) {
        EXPECT_EQ(cubics[i - 1].p3, cubics[i].p0);
        const Vec2 in = glm::normalize(cubics[i - 1].p3 - cubics[i - 1].p2);
        const Vec2 out = glm::normalize(cubics[i].p1 - cubics[i].p0);
        EXPECT_NEAR(glm::distance(in, out), 0, 1e-9);
    }
}

TEST(FitCubics, CircleArcsNeedAsFewAsTheyCan) {
    // The best cubic with G1 ends over an angle a misses the radius by about 2.7e-4 (a / 90 deg)^6.
    for (const auto& [tolerance, most] : {std::pair{0.1, 4u}, {0.01, 5u}, {0.001, 7u}}) {
        const auto samples = sampled(arc(100, 2 * shapes::kPi), 400);
        const auto cubics = fit_cubics(samples, tolerance);
        EXPECT_LE(cubics.size(), most);
        expect_close_and_smooth(samples, cubics, tolerance);
    }
}

TEST(FitCubics, QuarterCircleIsOneCubic) {
    EXPECT_EQ(fit_cubics(sampled(arc(100, shapes::kPi / 2), 50), 0.03).size(), 1u);
}

TEST(FitCubics, ACubicIsFoundAgain) {
    const Cubic c{{3, 4}, {13, 8}, {20, -5}, {33, 9}};  // S-shaped
    const auto samples = sampled(
        [&](double u) {
            return CurveSample{eval(c, u), derivative(c, u)};
        },
        60);
    const auto cubics = fit_cubics(samples, 0.01);
    ASSERT_EQ(cubics.size(), 1u);
    EXPECT_NEAR(glm::distance(cubics[0].p1, c.p1), 0, 0.05);
    EXPECT_NEAR(glm::distance(cubics[0].p2, c.p2), 0, 0.05);
}

TEST(FitCubics, SineWavesStayWithinTheTolerance) {
    for (const double tolerance : {1.0, 0.1, 0.01}) {
        const auto samples = sampled(sine(2), 400);
        const auto cubics = fit_cubics(samples, tolerance);
        EXPECT_LE(cubics.size(), 8u);
        expect_close_and_smooth(samples, cubics, tolerance);
    }
}

TEST(FitCubics, AClosedLoopAndASpiralAreFollowed) {
    const auto spiral = sampled(
        [](double u) {
            const double a = 30 * u, r = 1 + 3 * a;
            return CurveSample{
                {r * std::cos(a), r * std::sin(a)},
                {3 * std::cos(a) - r * std::sin(a), 3 * std::sin(a) + r * std::cos(a)}};
        },
        600);
    const auto cubics = fit_cubics(spiral, 0.1);
    EXPECT_LE(cubics.size(), 16u);
    expect_close_and_smooth(spiral, cubics, 0.1);
}

TEST(FitCubics, StraightIsOneStraightCubic) {
    const auto samples = sampled(
        [](double u) {
            return CurveSample{{100 * u, 3 * u}, {100, 3}};
        },
        100);
    const auto cubics = fit_cubics(samples, 1e-6);
    ASSERT_EQ(cubics.size(), 1u);
    EXPECT_NEAR(glm::distance(cubics[0].p1, Vec2(100, 3) / 3.0), 0, 1e-9);
}

TEST(FitCubics, NoiseSmallerThanTheToleranceCostsNothing) {
    shapes::Random random;
    auto samples = sampled(arc(100, 1), 200);
    for (CurveSample& s : samples)
        s.position += 0.02 * Vec2(random() - 0.5, random() - 0.5);
    EXPECT_LE(fit_cubics(samples, 0.05).size(), 2u);
}

TEST(FitCubics, TwoSamplesGiveOneCubicWithTheirTangents) {
    const std::vector<CurveSample> samples{{{0, 0}, {0, 2}}, {{10, 0}, {0, -7}}};
    const auto cubics = fit_cubics(samples, 0.1);
    ASSERT_EQ(cubics.size(), 1u);
    EXPECT_NEAR(cubics[0].p1.x, 0, 1e-12);
    EXPECT_GT(cubics[0].p1.y, 0);
    EXPECT_NEAR(cubics[0].p2.x, 10, 1e-12);
    EXPECT_NEAR(eval(cubics[0], 0.5).y, 5, 1e-9);  // a half circle
}

TEST(FitCubics, CoincidentSamplesCountOnce) {
    EXPECT_TRUE(fit_cubics({}, 0.1).empty());
    const CurveSample a{{1, 1}, {1, 0}}, b{{2, 1}, {1, 0}};
    EXPECT_TRUE(fit_cubics(std::vector{a, a, a}, 0.1).empty());
    EXPECT_EQ(fit_cubics(std::vector{a, a, b, b}, 0.1).size(), 1u);
}

}  // namespace
}  // namespace edaha
