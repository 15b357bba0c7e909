// SPDX-License-Identifier: MIT
#include "surface/burls.h"

#include <gtest/gtest.h>

#include "base/keyed_random.h"

namespace edaha {
namespace {

TEST(BurlGain, IsAPlateauWithASlopeToNothing) {
    const BurlSphere sphere{{0, 0, 0}, 300, 160, 0.5};
    EXPECT_EQ(burl_gain({0, 0, 0}, sphere), 0.5);
    EXPECT_EQ(burl_gain({160, 0, 0}, sphere), 0.5);
    EXPECT_DOUBLE_EQ(burl_gain({0, 230, 0}, sphere), 0.25);
    EXPECT_NEAR(burl_gain({0, 0, 300 - 1e-9}, sphere), 0, 1e-11);
    EXPECT_EQ(burl_gain({0, 0, 300}, sphere), 0);
    EXPECT_EQ(burl_gain({9000, 0, 0}, sphere), 0);
}

TEST(BurlGain, WithoutASlopeItIsAStep) {
    const BurlSphere sphere{{0, 0, 0}, 100, 100, 2};
    EXPECT_EQ(burl_gain({99, 0, 0}, sphere), 2);
    EXPECT_EQ(burl_gain({101, 0, 0}, sphere), 0);
}

// By cells as by all against all, in the same order: the same bits.
TEST(BurlField, TellsTheLargestOfOverlappingSpheres) {
    const std::vector<BurlSphere> spheres{{{0, 0, 0}, 300, 160, 3}, {{100, 0, 0}, 300, 160, 2}};
    const BurlField field(spheres);
    EXPECT_EQ(field.largest({100, 0, 0}), 3);
    EXPECT_EQ(field.largest({250, 0, 0}), 2);  // of the first a third and less
    EXPECT_EQ(field.largest({0, 500, 0}), 0);
    EXPECT_EQ(BurlField({}).largest({0, 0, 0}), 0);
}

TEST(BurlField, AddsAllSpheresUp) {
    const KeyedRandom random(0, 5, 1);
    std::vector<BurlSphere> spheres;
    const auto number = [&](Key key, std::uint32_t i, double least, double most) {
        return least + (most - least) * random.uniform(key, i);
    };
    const auto place = [&](Key key) {
        return Vec3(number(key, 0, -2000, 2000), number(key, 1, -2000, 2000),
                    number(key, 2, -2000, 2000));
    };
    for (Key key = 0; key < 60; ++key)
        spheres.push_back({place(key), number(key, 3, 200, 900), 100, number(key, 4, 0, 2)});
    const BurlField field(spheres);
    bool any = false;
    for (Key key = 100; key < 1100; ++key) {
        const Vec3 p = place(key);
        double sum = 1;
        for (const BurlSphere& sphere : spheres)
            sum += burl_gain(p, sphere);
        EXPECT_EQ(field.factor(p), sum);
        any = any || sum > 1;
    }
    EXPECT_TRUE(any);
    EXPECT_EQ(BurlField({}).factor({1, 2, 3}), 1);
}

}  // namespace
}  // namespace edaha
