// SPDX-License-Identifier: MIT
#include "app/sprigs.h"

#include <algorithm>
#include <cmath>
#include <span>

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

double reach(std::span<const Symbol> parts) {
    double most = 0;
    for (const Symbol& symbol : parts) {
        for (const Shape& shape : symbol.shapes) {
            for (const Vec2 point : shape.path.points)
                most = std::max(most, glm::length(point));
        }
    }
    return most;
}

// Of a layer: of all its instances, with how they are painted.
struct Placed {
    Use use;
    Paint paint;
};

void collect(const std::vector<Element>& elements, const Paint& paint, std::vector<Placed>& all) {
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element)) {
            collect(group->children,
                    group->paint.fill.kind == Ink::Kind::colour ? group->paint : paint, all);
        } else {
            const Use& use = std::get<Use>(element);
            all.push_back({use, use.paint.fill.kind == Ink::Kind::colour ? use.paint : paint});
        }
    }
}

std::vector<Placed> instances(const Layer& layer) {
    std::vector<Placed> all;
    collect(layer.children, layer.paint, all);
    return all;
}

SprigInks test_inks() {
    Palette palette;
    palette.strict = true;
    return sprig_inks(palette);
}

SprigLayers placed(std::span<const SprigPlace> places, const SprigParams& params) {
    return place_sprigs(places, {0, 1}, params, test_inks(), {-0.5, -0.7, 0.5}, {1, 1, 1});
}

// How wide wood is there, across a small range of heights: the points of its outline.
double width_near(const Symbol& stem, double low, double high) {
    double left = 0, right = 0;
    for (const Shape& shape : stem.shapes) {
        for (const Vec2 point : shape.path.points) {
            if (-point.y < low || -point.y > high) continue;
            left = std::min(left, point.x);
            right = std::max(right, point.x);
        }
    }
    return right - left;
}

// A wide foot would stick out behind a twig that is thinner.
TEST(Sprigs, HaveStemsThatBeginThin) {
    const std::vector<Symbol> sprigs = grow_sprigs(sprig_style(), load_leaf);
    for (std::size_t variant = 0; variant < 3; ++variant) {
        const Symbol& stem = sprigs[variant * kSprigParts];
        const double foot = width_near(stem, -1, 0.02), above = width_near(stem, 0.3, 2.5);
        EXPECT_GT(foot, 0);
        EXPECT_LT(foot, 0.5 * above) << variant;
    }
}

TEST(Sprigs, AreOfThreePartsThatTogetherReachAsFarAsALeaf) {
    const std::vector<Symbol> sprigs = grow_sprigs(sprig_style(), load_leaf);
    ASSERT_EQ(sprigs.size(), 3 * kSprigParts);
    for (std::size_t variant = 0; variant < 3; ++variant) {
        const std::span parts = std::span(sprigs).subspan(variant * kSprigParts, kSprigParts);
        EXPECT_NEAR(reach(parts), kLeafLength, 1e-9);
        for (const Symbol& part : parts) {
            ASSERT_EQ(part.shapes.size(), 1U) << part.id;
            EXPECT_EQ(part.shapes[0].paint.fill.kind, Ink::Kind::inherit) << part.id;
        }
        EXPECT_LT(reach(parts.subspan(1, 1)), reach(parts.subspan(2, 1)));
    }
    EXPECT_NE(sprigs[0].shapes[0].path.points, sprigs[kSprigParts].shapes[0].path.points);
}

TEST(Sprigs, FruitKeepsItsColourAmongLeaves) {
    Style style = sprig_style();
    style.fruit.shape = "apple";
    const std::vector<Symbol> sprigs = grow_sprigs(style, load_leaf);
    const std::vector<Shape>& outer = sprigs[SprigSymbols{0, 3}.index(SprigPart::outer, 0)].shapes;
    ASSERT_GT(outer.size(), 1U);
    EXPECT_EQ(outer.front().paint.fill.kind, Ink::Kind::inherit);
    EXPECT_EQ(outer.back().paint.fill.kind, Ink::Kind::colour);
}

TEST(Sprigs, ASprigIsForeshortenedButNeverFlat) {
    SprigParams params;
    params.size_spread = 0;
    params.droop = 0;
    const auto length = [&](double seen) {
        SprigPlace place;
        place.size_mm = 20;
        place.direction = {seen, 0, std::sqrt(1 - seen * seen)};
        params.rounding = 0;
        const SprigLayers layers = placed(std::span(&place, 1), params);
        return glm::length(instances(layers.front).at(0).use.page_from_symbol[1]) * kLeafLength;
    };
    const double whole = length(1);
    EXPECT_GT(length(0), whole / 2);
    EXPECT_LT(length(0), length(0.5));
    EXPECT_LT(length(0.5), whole);
    EXPECT_LE(whole, 20 + 1e-9);
}

std::vector<SprigPlace> ball_of_sprigs() {
    std::vector<SprigPlace> places;
    for (int i = 0; i < 400; ++i) {
        const double z = 1 - (i + 0.5) / 200;
        const double angle = 2.4 * i, round = std::sqrt(1 - z * z);
        SprigPlace place;
        place.key = static_cast<Key>(i);
        place.direction = {round * std::cos(angle), round * std::sin(angle), z};
        place.foot = 20.0 * place.direction;
        place.size_mm = 8;
        places.push_back(place);
    }
    return places;
}

TEST(Sprigs, AllStemsLieBehindTheWood) {
    const SprigLayers layers = placed(ball_of_sprigs(), {});
    EXPECT_EQ(layers.count, 400U);
    EXPECT_EQ(layers.front.label, "Sprigs");
    EXPECT_EQ(layers.behind.label, "Sprigs behind");
    const auto is_stem = [](const Placed& placed) { return placed.use.symbol == 0; };
    const std::vector<Placed> behind = instances(layers.behind), front = instances(layers.front);
    EXPECT_EQ(std::ranges::count_if(behind, is_stem), 400);
    EXPECT_EQ(std::ranges::count_if(front, is_stem), 0);
    EXPECT_GT(front.size(), 200U);
    EXPECT_EQ(behind.size() + front.size(), 400 * kSprigParts);
}

TEST(Sprigs, ABallIsLightWhereTheLightComesFromAndDarkBelow) {
    SprigParams params;
    params.clump = 1000;
    const SprigInks inks = test_inks();
    double light = 0, shade = 0;
    std::size_t lights = 0, shades = 0;
    for (const Placed& placed : instances(placed(ball_of_sprigs(), params).front)) {
        const double y = placed.use.page_from_symbol[2].y;
        if (placed.paint.fill.colour == inks.leaves[std::size_t(SprigTone::light)].outer)
            light += y, ++lights;
        if (placed.paint.fill.colour == inks.leaves[std::size_t(SprigTone::shade)].inner)
            shade += y, ++shades;
    }
    ASSERT_GT(lights, 20U);
    ASSERT_GT(shades, 20U);
    EXPECT_LT(light / static_cast<double>(lights), -4);
    EXPECT_GT(shade / static_cast<double>(shades), 4);
}

TEST(Sprigs, TheFarHalfFades) {
    const SprigInks inks = test_inks();
    const Colour far = inks.leaves[std::size_t(SprigTone::far)].outer;
    const auto is_far = [&](const Placed& placed) { return placed.paint.fill.colour == far; };
    const SprigLayers layers = placed(ball_of_sprigs(), {});
    EXPECT_TRUE(std::ranges::any_of(instances(layers.behind), is_far));
    EXPECT_TRUE(std::ranges::none_of(instances(layers.front), is_far));
}

}  // namespace
}  // namespace edaha
