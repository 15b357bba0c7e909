// SPDX-License-Identifier: MIT
#include "energy/ground.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "drawing/check.h"
#include "drawing/page.h"
#include "geometry/bounds.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

Stand stand_on_roots() {
    Stand stand;
    stand.foot = {100, 200};
    stand.foot_width_mm = 10;
    stand.crown_left_mm = 60;
    stand.crown_right_mm = 140;
    stand.roots = {{{30, 195}, 2}, {{190, 204}, 3}, {{120, 212}, 1.5}, {{90, 190}, 1}};
    return stand;
}

Layer drawn(Ground ground, const Stand& stand) {
    LookParams look;
    look.ground = ground;
    return draw_ground(stand, look, Palette{});
}

const Shape& shape_of(const Layer& layer, std::size_t i) {
    return std::get<Shape>(layer.children.at(i));
}

TEST(Ground, KeepsTheContract) {
    for (const Ground ground : {Ground::shadow, Ground::mound, Ground::water}) {
        for (const Stand& stand : {stand_on_roots(), Stand{{0, 0}, 5, -20, 30, {}}}) {
            Drawing drawing;
            drawing.layers.push_back(drawn(ground, stand));
            EXPECT_TRUE(check(on_page(std::move(drawing), PageParams{}, Palette{})).empty());
        }
    }
    EXPECT_TRUE(drawn(Ground::none, stand_on_roots()).children.empty());
}

TEST(Ground, ReachesUnderAllRoots) {
    const Stand stand = stand_on_roots();
    for (const Ground ground : {Ground::shadow, Ground::mound, Ground::water}) {
        const Bounds box = bounds(shape_of(drawn(ground, stand), 0).path);
        for (const Footing& root : stand.roots) {
            EXPECT_TRUE(box.contains(root.middle + Vec2(root.half_width_mm, 0)));
            EXPECT_TRUE(box.contains(root.middle - Vec2(root.half_width_mm, 0)));
        }
    }
}

TEST(Ground, WaterRipplesRoundEachRootAndTheTrunk) {
    const Stand stand = stand_on_roots();
    const Layer water = drawn(Ground::water, stand);
    ASSERT_EQ(water.children.size(), 4U);
    const Shape& ripples = shape_of(water, 2);
    EXPECT_EQ(ripples.id, "ripples");
    // Rings with a hole each, whose areas add up ring by ring.
    const auto moves = std::count(ripples.path.verbs.begin(), ripples.path.verbs.end(), Verb::move);
    EXPECT_EQ(moves, 2 * 5);
    EXPECT_GT(signed_area(ripples.path), 0);
    const Bounds box = bounds(ripples.path);
    for (const Footing& root : stand.roots)
        EXPECT_TRUE(box.contains(root.middle));
    EXPECT_TRUE(box.contains(stand.foot));
    // A tree without such roots stands in the middle of its ripples, and these in the water.
    const Layer pond = drawn(Ground::water, Stand{{0, 0}, 5, -2, 2, {}});
    const Bounds all = bounds(shape_of(pond, 0).path), ring = bounds(shape_of(pond, 2).path);
    EXPECT_TRUE(all.contains(ring.min));
    EXPECT_TRUE(all.contains(ring.max));
}

}  // namespace
}  // namespace edaha
