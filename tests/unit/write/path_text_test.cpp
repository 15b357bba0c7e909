// SPDX-License-Identifier: MIT
#include "write/path_text.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ornament/path_data.h"

namespace edaha {
namespace {

std::string data(const Path& path, int decimals = 2) {
    std::string text;
    append_path_data(text, path, decimals);
    return text;
}

TEST(PathText, TakesTheShorterOfRelativeAndAbsolute) {
    Path path;
    path.move_to({100, 100}), path.line_to({101, 102}), path.line_to({2, 3});
    EXPECT_EQ(data(path), "M100 100l1 2L2 3");
}

TEST(PathText, LeavesOutWhatTheGrammarDoesNotNeed) {
    Path path;
    path.move_to({0.5, -0.5}), path.line_to({1, 0.25}), path.line_to({1.5, -3}), path.close();
    EXPECT_EQ(data(path), "M.5-.5l.5.75L1.5-3z");
    Path absolute;  // a line after a move needs no letter
    absolute.move_to({99, 99}), absolute.line_to({1, 2}), absolute.line_to({-8, 9});
    EXPECT_EQ(data(absolute), "M99 99 1 2-8 9");
    Path two;
    two.move_to({1, 1}), two.line_to({3, 4}), two.move_to({10, 10}), two.line_to({11, 12});
    EXPECT_EQ(data(two), "M1 1l2 3m7 6 1 2");
}

TEST(PathText, LevelAndUprightLinesAreShort) {
    Path path;
    path.move_to({1, 1}), path.line_to({9, 1.004}), path.line_to({9.004, 5}), path.line_to({1, 5});
    path.close();
    EXPECT_EQ(data(path), "M1 1h8v4H1z");
}

TEST(PathText, SmoothCurvesNameOneControlPointLess) {
    Path path;
    path.move_to({0, 0}), path.cubic_to({0, 5}, {5, 10}, {10, 10});
    path.cubic_to({15, 10}, {20, 15}, {20, 20});
    EXPECT_EQ(data(path), "M0 0c0 5 5 10 10 10s10 5 10 10");
    Path first;  // without a curve before, s stands for the pen's place
    first.move_to({1, 1}), first.cubic_to({1, 1}, {3, 1}, {3, 3});
    EXPECT_EQ(data(first), "M1 1s2 0 2 2");
}

TEST(PathText, ACurveWithoutArmsIsALine) {
    Path path;
    path.move_to({1, 1}), path.cubic_to({1, 1}, {3, 4}, {3, 4});
    EXPECT_EQ(data(path), "M1 1l2 3");
}

TEST(PathText, TheWayBackIsLeftToTheClose) {
    Path path;
    path.move_to({1, 1}), path.line_to({5, 2}), path.line_to({3, 7}), path.line_to({1, 1});
    path.close();
    EXPECT_EQ(data(path), "M1 1l4 1-2 5z");
}

TEST(PathText, WhatRoundsToNothingIsLeftOut) {
    Path path;
    path.move_to({1, 1}), path.line_to({1.001, 1.002}), path.line_to({3, 4});
    EXPECT_EQ(data(path), "M1 1l2 3");
    Path speck;
    speck.move_to({1, 1}), speck.line_to({1.001, 1}), speck.line_to({1, 1.001}), speck.close();
    EXPECT_EQ(data(speck), "");
    Path both = speck;
    both.move_to({2, 2}), both.line_to({4, 5});
    EXPECT_EQ(data(both), "M2 2l2 3");
    EXPECT_EQ(data({}), "");
}

// A step of a third of a unit, a thousand times: offsets that were rounded each for itself would
// have drifted by 3.33.
TEST(PathText, ErrorsDoNotAddUp) {
    Path path;
    path.move_to({0, 0});
    for (int i = 1; i <= 1000; ++i)
        path.line_to({i * 0.333, i * 0.667});
    const Path back = read_path_data(data(path, 1));
    EXPECT_NEAR(back.points.back().x, 333, 0.0501);
    EXPECT_NEAR(back.points.back().y, 667, 0.0501);
}

// Random paths on the grid of the last decimal are read back to the point, by a reader that knows
// nothing of the writer. Small ranges make level, upright and smooth segments frequent.
TEST(PathText, AReaderGetsTheSamePath) {
    std::mt19937_64 random(11);
    for (int round = 0; round < 3000; ++round) {
        const int decimals = static_cast<int>(random() % 5);
        const double unit = std::pow(10.0, -decimals);
        const auto range = static_cast<std::int64_t>(random() % 2 ? 7 : 100000);
        const auto any = [&] {
            const auto number = static_cast<std::int64_t>(random() % (2 * range)) - range;
            return static_cast<double>(number) * unit;
        };
        const auto point = [&] { return Vec2(any(), any()); };
        Path path;
        const auto different = [&](Vec2 from) {
            Vec2 p = point();
            while (p == from || p == path.points[0])
                p = point();
            return p;
        };
        path.move_to(point());
        for (int i = 0; i < 12; ++i) {
            const Vec2 from = path.points.back();
            if (random() % 2) {
                path.line_to(different(from));
            } else if (random() % 2 && path.verbs.back() == Verb::cubic) {  // smooth
                const Vec2 mirrored = 2.0 * from - path.points[path.points.size() - 2];
                path.cubic_to(mirrored, point(), different(from));
            } else {
                const Vec2 to = different(from);
                path.cubic_to(different(from), to + Vec2(unit, 0), to);
            }
        }
        if (random() % 2) path.close();
        const std::string text = data(path, decimals);
        const Path back = read_path_data(text);
        ASSERT_EQ(back.verbs, path.verbs) << text;
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            ASSERT_NEAR(back.points[i].x, path.points[i].x, unit * 1e-3) << text;
            ASSERT_NEAR(back.points[i].y, path.points[i].y, unit * 1e-3) << text;
        }
    }
}

}  // namespace
}  // namespace edaha
