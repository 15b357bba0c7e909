// SPDX-License-Identifier: MIT
#include "energy/density_grid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace edaha {

TEST(DensityGrid, IsEmptyAtFirstAndEverywhere) {
    const DensityGrid grid(4);
    EXPECT_EQ(grid.density({0, 0}), 0);
    EXPECT_EQ(grid.density({-1e9, 1e9}), 0);
}

TEST(DensityGrid, AddsToTheCellThatAPointFallsIn) {
    DensityGrid grid(4);
    grid.add({1, 1}, 0.5);
    grid.add({3.9, 0.1}, 0.25);
    EXPECT_EQ(grid.density({2, 2}), 0.75);
    EXPECT_EQ(grid.density({4.1, 1}), 0);
    EXPECT_EQ(grid.density({-0.1, 1}), 0);
}

TEST(DensityGrid, GrowsInEveryDirectionAndForgetsNothing) {
    DensityGrid grid(1);
    for (int i = 0; i < 500; ++i)
        grid.add({i * 7.0 - 1700, 900 - i * 5.0}, i + 1);
    for (int i = 0; i < 500; ++i)
        EXPECT_EQ(grid.density({i * 7.0 - 1700, 900 - i * 5.0}), i + 1) << i;
}

TEST(DensityGrid, ASegmentLeavesItsLengthInItsCells) {
    DensityGrid grid(2);
    grid.add_segment({-3, 1}, {5, 1}, 1);  // 4 cells long: cells -2 -1 0 1 2 in halves at the ends
    EXPECT_NEAR(grid.density({-3, 1}), 0.5, 1e-6);
    EXPECT_NEAR(grid.density({-1, 1}), 1, 1e-6);
    EXPECT_NEAR(grid.density({1, 1}), 1, 1e-6);
    EXPECT_NEAR(grid.density({3, 1}), 1, 1e-6);
    EXPECT_NEAR(grid.density({4.5, 1}), 0.5, 1e-6);
    EXPECT_EQ(grid.density({1, 3}), 0);
}

TEST(DensityGrid, ASlantingSegmentSumsToItsLength) {
    DensityGrid grid(1.5);
    grid.add_segment({-7.3, -2.1}, {11.9, 14.2}, 1);
    double sum = 0;
    for (double x = -20; x < 20; x += 1.5) {
        for (double y = -20; y < 20; y += 1.5)
            sum += grid.density({x + 0.7, y + 0.7});
    }
    EXPECT_NEAR(sum, std::hypot(19.2, 16.3) / 1.5, 1e-4);
}

TEST(DensityGrid, RefusesWhatItCannotHold) {
    DensityGrid grid(1e-3);
    grid.add({0, 0}, 1);
    EXPECT_THROW(grid.add({1e7, 1e7}, 1), IoError);
    EXPECT_THROW(grid.add({1e300, 0}, 1), IoError);
}

}  // namespace edaha
