// SPDX-License-Identifier: MIT
#include "base/stable_math.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace edaha {
namespace {

// A spread of doubles in [low, high] that hits no special values.
template <typename Check>
void sweep(double low, double high, Check check) {
    for (int i = 0; i <= 20'000; ++i)
        check(low + (high - low) * (i + 0.137) / 20'001);
}

}  // namespace

// The system's functions are good to an ulp or two: an independent oracle.
TEST(StableMath, SinAndCos) {
    for (const double span : {1.0, 100.0, 1e5}) {
        sweep(-span, span, [](double x) {
            const auto [s, c] = stable::sin_cos(x);
            EXPECT_NEAR(s, std::sin(x), 4e-16) << x;
            EXPECT_NEAR(c, std::cos(x), 4e-16) << x;
        });
    }
}

TEST(StableMath, ExpLogPow) {
    sweep(-50, 50, [](double x) { EXPECT_NEAR(stable::exp(x) / std::exp(x), 1, 2e-15) << x; });
    sweep(-300, 300, [](double x) {
        const double y = std::exp2(x);
        EXPECT_NEAR(stable::log(y), std::log(y), 4e-16 * std::abs(std::log(y)) + 1e-17) << y;
    });
    sweep(0.01, 1e4, [](double x) {
        EXPECT_NEAR(stable::pow(x, 0.4) / std::pow(x, 0.4), 1, 4e-15) << x;
        EXPECT_EQ(stable::pow(x, 0.5), std::sqrt(x));
    });
}

TEST(StableMath, NormalDistribution) {
    sweep(-8, 8, [](double z) {
        EXPECT_NEAR(stable::normal_cdf(z), 0.5 * std::erfc(-z / std::numbers::sqrt2), 1e-14) << z;
    });
    EXPECT_EQ(stable::normal_cdf(9), 1);
    EXPECT_EQ(stable::normal_cdf(-9), 0);
    sweep(1e-9, 1 - 1e-9, [](double u) {
        EXPECT_NEAR(stable::normal_cdf(stable::normal_quantile(u)), u, 1e-9) << u;
    });
}

TEST(StableMath, Atan2InAllQuadrants) {
    sweep(-std::numbers::pi, std::numbers::pi, [](double angle) {
        EXPECT_NEAR(stable::atan2(3 * std::sin(angle), 3 * std::cos(angle)), angle, 1e-15) << angle;
    });
    EXPECT_EQ(stable::atan2(0, 0), 0);
}

}  // namespace edaha
