// SPDX-License-Identifier: MIT
#include "proproot/root_tables.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "proproot/prop_roots.h"

namespace edaha::test {
namespace {

struct Row {
    int first, last;
    double highest;
    int max_order;
    double branchings;
    int max_branchings;
};
// Tables 3.1, 3.3 and 3.4 of the thesis, joined.
constexpr std::array<Row, 7> kThesis{{{1, 5, 40, 1, 0, 0},
                                      {6, 8, 60, 1, 0.3, 2},
                                      {9, 14, 90, 2, 0.8, 3},
                                      {15, 18, 100, 3, 1.0, 4},
                                      {19, 30, 110, 4, 1.5, 5},
                                      {31, 50, 120, 5, 2.0, 5},
                                      {51, 100, 130, 5, 2.5, 6}}};

TEST(RootTables, HoldForEveryNumberOfPrimaries) {
    for (const Row& row : kThesis) {
        for (int x = row.first; x <= row.last; ++x) {
            const RootAge& age = root_age(x);
            EXPECT_EQ(age.highest, row.highest) << x;
            EXPECT_EQ(age.max_order, row.max_order) << x;
            EXPECT_EQ(age.branchings, row.branchings) << x;
            EXPECT_EQ(age.max_branchings, row.max_branchings) << x;
        }
    }
}

TEST(RootTables, TheUsersHeightComesFirst) {
    PropRootParams params;
    EXPECT_EQ(highest_primary(params, 20), 110);
    params.highest = 77;
    EXPECT_EQ(highest_primary(params, 20), 77);
    params.highest = 2;
    EXPECT_EQ(highest_primary(params, 20), 9);
}

TEST(RootTables, SlopesGrowWithTheTurn) {
    const double factors[] = {1, 2, 4, 6, 8, 10, 15, 20, 25};
    for (int bin = 0; bin < 9; ++bin) {
        for (const double degrees : {0.5, 10.0, 19.5}) {
            const double turn = (20 * bin + degrees) * std::numbers::pi / 180;
            EXPECT_EQ(slope_factor(turn), factors[bin]) << turn;
            EXPECT_EQ(slope_factor(-turn), factors[bin]) << turn;
        }
    }
}

TEST(RootTables, RadiiFollowTheAgeAndTheOrder) {
    EXPECT_DOUBLE_EQ(root_radius(49, 1), 5.9);
    EXPECT_DOUBLE_EQ(root_radius(49, 2), 5.9 * 0.8);
    EXPECT_DOUBLE_EQ(root_radius(10, 4), 2 * 0.8 * 0.8 * 0.8);
    EXPECT_DOUBLE_EQ(trunk_radius(20), 7);
}

TEST(RootTables, LargerAndDeeperSeedlingsStrikeMoreRoots) {
    PropRootParams params;
    params.primaries = 40;
    EXPECT_EQ(effective_primaries(params), 40);
    params.propagule_length = 45;
    EXPECT_EQ(effective_primaries(params), 60);
    params.planting_depth = 1;
    EXPECT_EQ(effective_primaries(params), 78);
    params.propagule_length = 60;
    params.primaries = 100;
    EXPECT_EQ(effective_primaries(params), 100);
    params = {};
    params.primaries = 1;
    params.propagule_length = 15;
    EXPECT_EQ(effective_primaries(params), 1);
}

}  // namespace
}  // namespace edaha::test
