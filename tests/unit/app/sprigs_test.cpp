// SPDX-License-Identifier: MIT
#include "app/sprigs.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "ornament/place_sprigs.h"
#include "style/catalogue.h"

namespace edaha {
namespace {

LeafImport load_leaf(const std::string& name) {
    return read_leaf(Catalogue().find_leaf(name).text, name);
}

Style sprig_style() {
    Style style;
    style.sprig.energy = 12;
    style.sprig.variants = 3;
    style.leaf.shape = "oak";
    return style;
}

double reach(const Symbol& symbol) {
    double most = 0;
    for (const Shape& shape : symbol.shapes) {
        for (const Vec2 point : shape.path.points)
            most = std::max(most, glm::length(point));
    }
    return most;
}

TEST(Sprigs, EachVariantComesInAllTonesWithOneOutline) {
    const std::vector<Symbol> sprigs = grow_sprigs(sprig_style(), load_leaf);
    ASSERT_EQ(sprigs.size(), 3 * kSprigTones);
    const SprigSymbols which{0, 3};
    for (std::uint32_t variant = 0; variant < 3; ++variant) {
        for (const SprigTone tone : {SprigTone::shade, SprigTone::light, SprigTone::back}) {
            const Symbol& one = sprigs[which.index(tone, variant)];
            EXPECT_FALSE(one.shapes.empty());
            EXPECT_NEAR(reach(one), kLeafLength, 1e-9);
        }
    }
    EXPECT_NE(sprigs[0].shapes.back().path.points, sprigs[1].shapes.back().path.points);
}

TEST(Sprigs, ASprigIsForeshortenedButNeverFlat) {
    SprigPlace place;
    place.site.direction = {1, 0};
    place.size_mm = 20;
    SprigParams params;
    params.size_spread = 0;
    params.droop = 0;
    const auto length = [&](double seen) {
        place.seen = seen;
        const SprigLayers layers =
            place_sprigs(std::span(&place, 1), {0, 1}, params,
                         [](std::int32_t) { return std::string("bough"); }, {1, 1, 1});
        const auto& group = std::get<Group>(layers.front.children.at(0));
        const Use& use = std::get<Use>(group.children.at(0));
        return glm::length(use.page_from_symbol[1]) * kLeafLength;
    };
    EXPECT_NEAR(length(1), 20, 1e-9);
    EXPECT_GT(length(0), 10);
    EXPECT_LT(length(0), length(0.5));
}

TEST(Sprigs, FarOnesComeFirstAndThoseBehindHaveTheirOwnLayer) {
    std::vector<SprigPlace> places(3);
    for (std::size_t i = 0; i < 3; ++i) {
        places[i].site.key = i;
        places[i].site.direction = {0, -1};
        places[i].site.position = {10.0 * static_cast<double>(i), 0};
    }
    places[0].depth = 5;
    places[1].depth = -5;
    places[2].site.back = true;
    const SprigLayers layers =
        place_sprigs(places, {0, 1}, {}, [](std::int32_t) { return std::string("b"); }, {1, 1, 1});
    EXPECT_EQ(layers.count, 3U);
    const auto& front = std::get<Group>(layers.front.children.at(0)).children;
    ASSERT_EQ(front.size(), 2U);
    EXPECT_EQ(std::get<Use>(front[0]).page_from_symbol[2].x, 10);
    EXPECT_EQ(std::get<Use>(front[1]).page_from_symbol[2].x, 0);
    ASSERT_EQ(layers.behind.children.size(), 1U);
    EXPECT_EQ(layers.front.label, "Sprigs");
    EXPECT_EQ(layers.behind.label, "Sprigs behind");
}

}  // namespace
}  // namespace edaha
