// SPDX-License-Identifier: MIT
#include "surface/rules.h"

#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.h"

namespace edaha {
namespace {

const KeyedRandom kRandom(0, 1, 1);
constexpr double kRad = std::numbers::pi / 180;

ApexState after(const std::string& text, int steps, std::vector<Bud>* buds = nullptr) {
    const auto rules = parse_rules(text, "a.xml");
    ApexState apex = first_apex(*rules, 60, 3);
    for (int i = 0; i < steps; ++i) {
        for (Bud& bud : advance(*rules, apex, kRandom, i)) {
            if (buds != nullptr) buds->push_back(std::move(bud));
        }
    }
    return apex;
}

// What `speed` is after `speed(EXPRESSION)`, where t is 7.
double value_of(const std::string& expression) {
    return after("k = 2; axiom: A(7); A(t) -> speed(" + expression + ")", 1).speed_mm;
}

std::string problems_of(const std::string& text) {
    try {
        parse_rules(text, "a.xml", 10);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Rules, Calculate) {
    EXPECT_EQ(value_of("1 + 2 * 3"), 7);
    EXPECT_EQ(value_of("(1 + 2) * 3"), 9);
    EXPECT_EQ(value_of("2 ^ 3 ^ 2"), 512);
    EXPECT_EQ(value_of("10 - 4 - 3"), 3);
    EXPECT_EQ(value_of("t % 4 + k"), 5);
    EXPECT_EQ(value_of("17 % 5"), 2);
    EXPECT_EQ(value_of("4 - -3"), 7);
    EXPECT_EQ(value_of("100 - 2 ^ 2"), 96);
    EXPECT_EQ(value_of("min(t, 3) + max(1, 2) + abs(0 - 4)"), 9);
    EXPECT_EQ(value_of("sqrt(2.25) + floor(2.9)"), 3.5);
    EXPECT_NEAR(value_of("sin(30) + cos(60)"), 1, 1e-12);
    EXPECT_EQ(value_of("(t > 5 && t < 8) + (t == 7 || 0) + !t + (t != 7) + (t >= 7) + (t <= 6)"),
              3);
    EXPECT_NEAR(value_of("2 ^ 0.5"), std::sqrt(2.0), 1e-12);
}

TEST(Rules, RewriteTheirModuleAtEachStep) {
    const ApexState apex = after("axiom: A(0)\nA(t) : t < 5 -> A(t + 1)\nA(t) -> stop", 5);
    ASSERT_TRUE(apex.module);
    EXPECT_EQ(apex.module->values[0], 5);
    EXPECT_FALSE(apex.stopped);
    EXPECT_TRUE(after("axiom: A(0)\nA(t) : t < 5 -> A(t + 1)\nA(t) -> stop", 6).stopped);
}

TEST(Rules, TheFirstThatHoldsIsTaken) {
    const std::string text =
        "axiom: A(0); A(t) : t > 2 -> speed(1) A(t + 1); A(t) -> speed(2) A(t + 1)";
    EXPECT_EQ(after(text, 3).speed_mm, 2);
    EXPECT_EQ(after(text, 4).speed_mm, 1);
}

// Of 4000 draws with weights 1 and 3: chi-square with one degree of freedom below 10.8 (p 0.001).
TEST(Rules, WeightsAreShares) {
    const auto rules = parse_rules(
        "axiom: A\nA : * : 1 -> speed(1) A\nA : * : 3 -> speed(3) A\nA -> speed(9) A", "a.xml");
    ApexState apex = first_apex(*rules, 60, 3);
    double ones = 0;
    for (int i = 0; i < 4000; ++i) {
        advance(*rules, apex, kRandom, i);
        ASSERT_NE(apex.speed_mm, 9);
        ones += apex.speed_mm == 1 ? 1 : 0;
    }
    const double off = ones - 1000;
    EXPECT_LT(off * off / 1000 + off * off / 3000, 10.8);
}

TEST(Rules, TurnAsTurtlesDo) {
    const ApexState plus = after("axiom: +(30)", 0);
    EXPECT_NEAR(glm::distance(plus.frame[0], Vec3(-0.5, std::cos(30 * kRad), 0)), 0, 1e-12);
    const ApexState down = after("axiom: &(90)", 0);
    EXPECT_NEAR(glm::distance(down.frame[0], Vec3(0, 0, -1)), 0, 1e-12);
    const ApexState round = after("axiom: /(90) +(90)", 0);
    EXPECT_NEAR(std::abs(round.frame[0].z), 1, 1e-12);
    EXPECT_NEAR(glm::distance(after("angle = 30; axiom: +", 0).frame[0], plus.frame[0]), 0, 1e-12);
    EXPECT_NEAR(after("axiom: |", 0).frame[0].y, -1, 1e-12);
}

TEST(Rules, FramesStaySquareOverManyTurns) {
    const ApexState apex = after("axiom: A; A -> +(7) &(11) /(13) A", 10'000);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(glm::dot(apex.frame[i], apex.frame[j]), i == j ? 1 : 0, 1e-12);
    }
}

TEST(Rules, TropismTurnsUpByAPartOfTheWay) {
    const ApexState apex = after("axiom: +(80) tropism(0.25)", 0);
    EXPECT_NEAR(apex.frame[0].y, std::cos(60 * kRad), 1e-9);
    EXPECT_NEAR(after("axiom: +(80) tropism(0 - 0.5)", 0).frame[0].y, std::cos(130 * kRad), 1e-9);
}

TEST(Rules, BudsPointAwayAndSproutAsTheyAreTold) {
    std::vector<Bud> buds;
    after("axiom: A(0); A(t) -> bud(40, 90 * t, 10 + t)[speed(20) B(t)] A(t + 1); B(t) -> B(t)", 3,
          &buds);
    ASSERT_EQ(buds.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(buds[i].direction.y, std::cos(40 * kRad), 1e-12);
        EXPECT_EQ(buds[i].delay, static_cast<std::int64_t>(10 + i));
        EXPECT_EQ(buds[i].state.speed_mm, 20);
        EXPECT_EQ(buds[i].state.order, 1U);
        EXPECT_EQ(buds[i].state.module->values[0], static_cast<double>(i));
    }
    EXPECT_NEAR(glm::dot(buds[0].direction, buds[2].direction), std::cos(80 * kRad), 1e-12);
    EXPECT_NE(buds[0].state.key, buds[1].state.key);
}

TEST(Rules, DrawsOfOneBranchLeaveTheOthersAlone) {
    std::vector<Bud> few, many;
    const std::string tail = " bud(random(0, 90), 0)[] A; A -> A";
    after("axiom: A; A -> bud(random(0, 90), 0)[] A", 1, &few);
    after("axiom: A; A -> bud(random(0, 90), 0)[speed(random(1, 9))] A", 1, &many);
    ASSERT_EQ(few.size(), many.size());
    EXPECT_EQ(few[0].direction, many[0].direction);
}

TEST(Rules, SayWhatIsWrong) {
    EXPECT_EQ(problems_of("axiom: A(0)\nA(t) -> spede(3) A(t)"),
              "a.xml:11:9: production 1: no production rewrites 'spede' (did you mean 'speed'?)");
    EXPECT_EQ(problems_of("A(t) : t >> 5 -> A(t)"),
              "a.xml:10:11: production 1: expected a number or a name here, not '>'");
    EXPECT_EQ(problems_of("A(t) -> A(u)"),
              "a.xml:10:11: production 1: nothing is called 'u' here (did you mean 't'?)");
    EXPECT_EQ(problems_of("A -> bud(1)[A]"),
              "a.xml:10:6: production 1: 'bud' takes 2 or 3 values, not 1");
    EXPECT_EQ(problems_of("A -> A A"),
              "a.xml:10:8: production 1: an apex is one module: this is a second one");
    EXPECT_EQ(problems_of("axiom: A(1); A(t, u) -> A(t, u)"),
              "a.xml:10:8: axiom: no production rewrites 'A' with 1 value");
    EXPECT_EQ(problems_of("k = 1; k = 2"), "a.xml:10:9: 'k' is set twice");
    EXPECT_EQ(problems_of("A -> speed(cso(3))"),
              "a.xml:10:12: production 1: there is no function 'cso' (did you mean 'cos'?)");
    EXPECT_EQ(problems_of("A(t -> A(t)"), "a.xml:10:5: production 1: expected ')' here, not '-'");
    EXPECT_EQ(problems_of("?"), "a.xml:10:1: expected a name here, not '?'");
    EXPECT_EQ(problems_of("A ->\n\nB ->\nA(\n"),
              "a.xml:14:1: production 3: expected the name of a value, not the end of the line");
}

TEST(Rules, NoValueIsEverInfinite) {
    EXPECT_THROW(after("axiom: A(0); A(t) -> speed(1 / t) A(t)", 1), InputError);
    EXPECT_THROW(after("axiom: A(0); A(t) -> speed(sqrt(0 - 1)) A(t)", 1), InputError);
    EXPECT_THROW(after("axiom: A(2); A(t) -> A(t ^ 2)", 20), InputError);
}

TEST(Rules, WithoutAnyAnApexGoesStraight) {
    const ApexState apex = after("", 10);
    EXPECT_EQ(apex.frame[0], Vec3(0, 1, 0));
    EXPECT_FALSE(apex.stopped);
}

}  // namespace
}  // namespace edaha
