// SPDX-License-Identifier: MIT
#include "flatten/absorb.h"

#include <gtest/gtest.h>

#include "unit/flatten/painter_scene.h"

namespace edaha {
namespace {

using scenes::Card;
using scenes::rectangle;

// Areas seen of each part, in square pixels.
std::vector<double> areas(const LabelledMap& map, std::size_t parts) {
    std::vector<double> result(parts, 0);
    for (std::uint32_t f = 1; f < map.map.faces(); ++f) {
        if (map.labels[f].part != kNone)
            result[map.labels[f].part] += face_area(map.map, f) / (2048.0 * 2048);
    }
    return result;
}

TEST(AbsorbSmallRegions, GivesAPatchToWhatItHasMostBorderWith) {
    // A patch of 1 x 1 across the border of two squares, more of it in the right one.
    const std::vector<Card> cards{{rectangle({0, 0}, {10, 10}), 0, 0},
                                  {rectangle({10, 0}, {20, 10}), 1, 0},
                                  {rectangle({9.75, 4}, {10.75, 5}), 2, 0}};
    const LabelledMap map = absorb_small_regions(scenes::map_of(cards), 2);
    const std::vector<double> seen = areas(map, 3);
    EXPECT_NEAR(seen[0], 100 - 0.25, 1e-9);
    EXPECT_NEAR(seen[1], 100 + 0.25, 1e-9);
    EXPECT_EQ(seen[2], 0);
}

TEST(AbsorbSmallRegions, LeavesNoLineWhereNothingIsDividedAnyMore) {
    const std::vector<Card> cards{{rectangle({0, 0}, {10, 10}), 0, 0},
                                  {rectangle({4, 4}, {5, 5}), 1, 0}};
    const LabelledMap map = absorb_small_regions(scenes::map_of(cards), 2);
    for (std::uint32_t e = 0; e < map.map.edges.size(); ++e) {
        const bool outer =
            map.labels[map.map.face_of(2 * e)].part != map.labels[map.map.face_of(2 * e + 1)].part;
        EXPECT_EQ(map.line[e], outer ? LineKind::silhouette : LineKind::none);
    }
}

TEST(AbsorbSmallRegions, ClosesSmallHolesAndDropsSpecksInTheSky) {
    // A frame around a hole of 1 x 1, and a speck beside it.
    const std::vector<Card> cards{{rectangle({0, 0}, {10, 4}), 0, 0},
                                  {rectangle({0, 5}, {10, 10}), 0, 0},
                                  {rectangle({0, 4}, {4, 5}), 0, 0},
                                  {rectangle({5, 4}, {10, 5}), 0, 0},
                                  {rectangle({15, 4}, {16, 5}), 1, 0}};
    const std::vector<double> seen = areas(absorb_small_regions(scenes::map_of(cards), 2), 2);
    EXPECT_NEAR(seen[0], 100, 1e-9);
    EXPECT_EQ(seen[1], 0);
    const std::vector<double> all = areas(absorb_small_regions(scenes::map_of(cards), 0.5), 2);
    EXPECT_NEAR(all[0], 99, 1e-9);
    EXPECT_NEAR(all[1], 1, 1e-9);
}

TEST(AbsorbSmallRegions, TakesSliversBetweenPartsButLeavesTwigsInTheSky) {
    const std::vector<Card> cards{{rectangle({0, 0}, {50, 10}), 0, 0},
                                  {rectangle({0, 10.1}, {50, 20}), 1, 0},
                                  {rectangle({0, 10}, {50, 10.1}), 2, 0},
                                  {rectangle({0, 30}, {50, 30.1}), 3, 0}};
    const std::vector<double> seen = areas(absorb_small_regions(scenes::map_of(cards), 2), 4);
    EXPECT_EQ(seen[2], 0);
    EXPECT_NEAR(seen[3], 5, 0.1);
    EXPECT_NEAR(seen[0] + seen[1], 1000, 0.1);
}

TEST(AbsorbSmallRegions, LeavesNothingSmallInRandomScenes) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const std::vector<Card> cards = scenes::random_scene(60, 200, seed);
        const LabelledMap before = scenes::map_of(cards);
        const LabelledMap after = absorb_small_regions(before, 3);
        const LabelledMap again = absorb_small_regions(after, 3);
        EXPECT_EQ(again.labels, after.labels);
        double moved = 0;
        for (std::uint32_t f = 1; f < before.map.faces(); ++f) {
            if (before.labels[f] != after.labels[f]) moved += face_area(before.map, f);
        }
        EXPECT_LT(moved / (2048.0 * 2048), 0.02 * 200 * 200);
    }
}

}  // namespace
}  // namespace edaha
