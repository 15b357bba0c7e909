// SPDX-License-Identifier: MIT
#include "write/precision.h"

#include <cmath>

#include <gtest/gtest.h>

namespace edaha {
namespace {

TEST(Precision, FollowsFromThePage) {
    EXPECT_EQ(page_decimals(200, 150), 2);
    EXPECT_EQ(page_decimals(1000, 10), 2);
    EXPECT_EQ(page_decimals(60, 60), 3);
    EXPECT_EQ(page_decimals(10000, 3000), 1);
    EXPECT_EQ(page_decimals(0.01, 0.01), 6);
    EXPECT_EQ(page_decimals(1e9, 1), 0);
}

TEST(Precision, TheStepIsATenthToAHundredthOfAPixel) {
    for (double size = 1; size < 90000; size *= 1.37) {
        const double step = std::pow(10.0, -page_decimals(size, size / 2));
        const double pixel = size / 1000;
        EXPECT_GE(step, pixel / 100 * 0.999) << size;
        EXPECT_LE(step, pixel / 10 * 1.001) << size;
    }
}

TEST(Precision, WhatIsShownLargerNeedsMoreDecimals) {
    EXPECT_EQ(decimals_at_scale(2, 1), 2);
    EXPECT_EQ(decimals_at_scale(2, 1.01), 3);
    EXPECT_EQ(decimals_at_scale(2, 10), 3);
    EXPECT_EQ(decimals_at_scale(2, 0.5), 2);
    EXPECT_EQ(decimals_at_scale(2, 0.05), 1);
    EXPECT_EQ(decimals_at_scale(2, 1e9), 6);
    EXPECT_EQ(decimals_at_scale(2, 1e-9), 0);
}

TEST(Precision, ScalesOfATurnedAndSqueezedMap) {
    const Affine map(0, 3, -0.5, 0, 7, 7);
    EXPECT_DOUBLE_EQ(largest_scale(map), 3);
    EXPECT_DOUBLE_EQ(mean_scale(map), std::sqrt(1.5));
}

}  // namespace
}  // namespace edaha
