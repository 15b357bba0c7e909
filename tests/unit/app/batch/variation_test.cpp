// SPDX-License-Identifier: MIT
#include "app/batch/variation.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "base/number_text.h"
#include "style/value.h"

namespace edaha {
namespace {

Variation parse(const std::string& assignment, bool swept = false) {
    return parse_variation(parse_assignment(swept ? "--sweep" : "--set", assignment), swept);
}

std::string error_of(const std::string& assignment, bool swept = false) {
    try {
        parse(assignment, swept);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

double number_at(const Variation& variation, const Position& position) {
    const auto value = parse_number(value_at(variation, position));
    EXPECT_TRUE(value);
    return value.value_or(0);
}

TEST(Variation, OneValueIsThatOfAll) {
    const Variation one = parse("growth.energy= 300 ");
    EXPECT_EQ(value_at(one, {1, 0, 9}), "300");
    EXPECT_EQ(value_at(one, {8, 7, 9}), "300");
    // What looks like a range of values may be the value of a range.
    EXPECT_EQ(value_at(parse("growth.lean=-12..-6"), {1, 0, 9}), "-12..-6");
}

TEST(Variation, DrawnNumbersAreUniform) {
    const Variation drawn = parse("growth.energy=100..800");
    constexpr int kCount = 4000;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < kCount; ++seed) {
        const double value = number_at(drawn, {static_cast<std::uint64_t>(seed), 0, 1});
        EXPECT_GE(value, 100);
        EXPECT_LE(value, 800);
        sum += value;
        squares += (value - 450) * (value - 450);
    }
    // Mean and variance of the uniform distribution, within five standard errors.
    const double deviation = 700 / std::sqrt(12.0);
    EXPECT_NEAR(sum / kCount, 450, 5 * deviation / std::sqrt(kCount));
    const double variance = deviation * deviation;
    EXPECT_NEAR(squares / kCount, variance, 5 * variance * std::sqrt(0.8 / kCount));
}

TEST(Variation, WhatIsDrawnDependsOnSeedAndParameterAlone) {
    const Variation energy = parse("growth.energy=1..2");
    EXPECT_EQ(value_at(energy, {5, 0, 1}), value_at(energy, {5, 99, 100}));
    EXPECT_NE(value_at(energy, {5, 0, 1}), value_at(energy, {6, 0, 1}));
    EXPECT_NE(value_at(energy, {5, 0, 1}), value_at(parse("leaf.size=1..2"), {5, 0, 1}));
}

TEST(Variation, DrawnNumbersHaveFewDecimals) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const std::string value = value_at(parse("growth.energy=100..800"), {seed, 0, 1});
        EXPECT_LE(value.size() - std::min(value.find('.'), value.size()), 2u) << value;
    }
}

TEST(Variation, WholeNumbersReachBothEndsAlike) {
    const Variation family = parse("variant.family=1..3");
    int counts[3] = {};
    constexpr int kCount = 3000;
    for (std::uint64_t seed = 0; seed < kCount; ++seed) {
        const double value = number_at(family, {seed, 0, 1});
        ASSERT_TRUE(value == 1 || value == 2 || value == 3) << value;
        ++counts[static_cast<int>(value) - 1];
    }
    for (const int count : counts)
        EXPECT_NEAR(count, kCount / 3, 5 * std::sqrt(kCount * 2 / 9.0));
}

TEST(Variation, ColoursLieBetweenTheEnds) {
    const Variation leaf = parse("palette.leaf=#204060..#80a0c0");
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Style style;
        EXPECT_EQ(assign(style, *leaf.parameter, value_at(leaf, {seed, 0, 1})), std::nullopt);
        const Colour colour = style.palette.leaf;
        // One share for all channels: the ends are 0x60 apart in each.
        EXPECT_EQ(colour.g - colour.r, 0x20);
        EXPECT_EQ(colour.b - colour.g, 0x20);
        EXPECT_GE(colour.r, 0x20);
        EXPECT_LE(colour.r, 0x80);
    }
}

TEST(Variation, SweepsGoEvenlyFromEndToEnd) {
    const Variation energy = parse("growth.energy=100..800", true);
    constexpr std::size_t kCount = 1000;
    EXPECT_EQ(value_at(energy, {1, 0, kCount}), "100");
    EXPECT_EQ(value_at(energy, {1, kCount - 1, kCount}), "800");
    const double even = 700.0 / (kCount - 1);
    for (std::size_t i = 1; i < kCount; ++i) {
        const double step =
            number_at(energy, {1, i, kCount}) - number_at(energy, {1, i - 1, kCount});
        EXPECT_NEAR(step, even, even / 500);
    }
    EXPECT_EQ(value_at(parse("growth.energy=800..100", true), {1, 1, 2}), "100");
    EXPECT_EQ(value_at(energy, {1, 0, 1}), "100");
    EXPECT_EQ(value_at(parse("variant.family=1..9", true), {1, 2, 5}), "5");
}

TEST(Variation, NamesComeInTurnOrByChance) {
    const Variation turn = parse("growth.type=A|B", true);
    EXPECT_EQ(value_at(turn, {1, 0, 9}) + value_at(turn, {1, 1, 9}) + value_at(turn, {1, 2, 9}),
              "ABA");
    const Variation chance = parse("growth.lean=-12..-6 | 0..5 | 10..20");
    std::map<std::string, int> counts;
    for (std::uint64_t seed = 0; seed < 3000; ++seed)
        ++counts[value_at(chance, {seed, 0, 1})];
    EXPECT_EQ(counts.size(), 3u);
    for (const auto& [value, count] : counts)
        EXPECT_NEAR(count, 1000, 5 * std::sqrt(3000 * 2 / 9.0)) << value;
}

TEST(Variation, EveryValueIsCheckedInTheTablesWords) {
    EXPECT_EQ(error_of("growth.energy=0..5"),
              "--set: growth.energy: '0' is out of range (expected 1 … 1e6)");
    EXPECT_EQ(error_of("growth.energy=1..x"),
              "--set: growth.energy: 'x' is not a number (expected 1 … 1e6)");
    EXPECT_EQ(error_of("growth.energy=5..1"), "--set: growth.energy: '5..1' is a reversed range");
    EXPECT_EQ(error_of("growth.type=A|C"),
              "--set: growth.type: 'C' is not known (expected A or B; did you mean 'A'?)");
    EXPECT_EQ(error_of("growth.enery=1..5"),
              "--set: growth.enery: no such parameter (did you mean 'growth.energy'?)");
    EXPECT_EQ(error_of("growth.energy"),
              "--set: 'growth.energy' is not an assignment (expected group.name=value)");
    EXPECT_EQ(error_of("variant.seed=1..5"),
              "--set: variant.seed: batch counts it from --seed-from");
    EXPECT_EQ(error_of("growth.energy=7", true),
              "--sweep: growth.energy: '7' is one value (expected a|b|c or a..b)");
    EXPECT_EQ(error_of("growth.lean=0..3", true),
              "--sweep: growth.lean: '0..3' is one value (expected a|b|c)");
    EXPECT_THROW(parse_variation({"--vary", "variant.vary", "0..2"}, false), UsageError);
}

}  // namespace
}  // namespace edaha
