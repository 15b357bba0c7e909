// SPDX-License-Identifier: MIT
#include "proproot/catenary.h"

#include <cmath>

#include <gtest/gtest.h>

namespace edaha::test {
namespace {

TEST(Catenary, IsTheThesissWithoutABulge) {
    for (const double a : {-550.0, -150.0, -10.0, -0.4}) {
        const Catenary curve{a, 90, 0};
        for (double x = 0; x < -6 * a; x += -0.3 * a) {
            const double expected = a * std::cosh(x / a) - a + 90;  // (3.5)
            EXPECT_NEAR(curve.height(x), expected, 1e-11 * (1 + std::abs(expected)));
        }
    }
}

TEST(Catenary, SlopeIsTheHeightsDerivative) {
    const Catenary curve = rising_catenary(-200, 60, 10);
    for (double x = 0; x < 250; x += 10) {
        const double h = 1e-4;
        const double slope = (curve.height(x + h) - curve.height(x - h)) / (2 * h);
        EXPECT_NEAR(curve.slope(x), slope, 1e-7);
    }
}

TEST(Catenary, LengthIsThatOfManyChords) {
    const Catenary curve = rising_catenary(-60, 50, 8);
    double sum = 0;
    constexpr int kChords = 20000;
    const double end = curve.at_height(0);
    for (int i = 0; i < kChords; ++i) {
        const double x0 = end * i / kChords, x1 = end * (i + 1) / kChords;
        sum += std::hypot(x1 - x0, curve.height(x1) - curve.height(x0));
    }
    EXPECT_NEAR(curve.length(end), sum, 1e-5);
}

TEST(Catenary, PlacesAreFoundByLengthAndHeight) {
    for (const double rise : {0.0, 12.0}) {
        const Catenary curve = rising_catenary(-250, 80, rise);
        for (double x = 0; x < 300; x += 7) {
            EXPECT_NEAR(curve.at_length(curve.length(x)), x, 1e-9);
            if (x > curve.apex) {
                EXPECT_NEAR(curve.at_height(curve.height(x)), x, 1e-6);
            }
        }
        EXPECT_NEAR(curve.height(curve.at_height(0)), 0, 1e-10);
    }
}

TEST(Catenary, RisesByWhatIsAsked) {
    const Catenary curve = rising_catenary(-300, 50, 10);
    EXPECT_NEAR(curve.height(0), 50, 1e-11);
    EXPECT_NEAR(curve.height(curve.apex), 60, 1e-10);
    EXPECT_GT(curve.apex, 0);
    EXPECT_NEAR(curve.slope(curve.apex), 0, 1e-15);
}

}  // namespace
}  // namespace edaha::test
