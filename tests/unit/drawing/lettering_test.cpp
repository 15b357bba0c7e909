// SPDX-License-Identifier: MIT
#include "drawing/lettering.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "drawing/check.h"
#include "geometry/bounds.h"

namespace edaha {
namespace {

using Anchor = LetteringParams::Anchor;

const std::vector<std::string> kPromised = [] {
    std::vector<std::string> letters;
    for (const char c : std::string("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                    "-_.,:;/%=+()#'<>&!?")) {
        letters.push_back(std::string(1, c));
    }
    letters.insert(letters.end(), {"\u00b0", "\u2026", "\u2013", "\u00d7"});
    return letters;
}();

Path box() {
    return lettering("\u679d", {10, Anchor::start, {0, 0}});
}

TEST(Lettering, HasAGlyphOfItsOwnForEachLetter) {
    std::set<std::vector<double>> seen;
    for (const std::string& letter : kPromised) {
        std::vector<double> numbers;
        for (const Vec2 p : lettering(letter, {10, Anchor::start, {0, 0}}).points)
            numbers.insert(numbers.end(), {p.x, p.y});
        EXPECT_TRUE(seen.insert(numbers).second) << letter;
    }
    EXPECT_EQ(seen.size(), 62U + 19 + 4);
}

TEST(Lettering, ShowsABoxForWhatItDoesNotHave) {
    EXPECT_EQ(box().verbs.size(), 5U);
    for (const std::string& letter : kPromised)
        EXPECT_NE(lettering(letter, {10, Anchor::start, {0, 0}}).points, box().points) << letter;
    // One for a letter, and for each byte that is no UTF-8.
    EXPECT_EQ(lettering("\u00e4", {}).verbs.size(), 5U);
    EXPECT_EQ(lettering("\xff\xfe", {}).verbs.size(), 10U);
}

TEST(Lettering, TheBlankHasWidthAndNoInk) {
    EXPECT_TRUE(lettering(" ", {}).empty());
    EXPECT_GT(lettering_width_mm(" ", 2), 0);
    EXPECT_TRUE(lettering("", {}).empty());
    EXPECT_EQ(lettering_width_mm("", 2), 0);
}

TEST(Lettering, SizeIsTheHeightOfACapital) {
    const Bounds capital = bounds(lettering("H", {3, Anchor::start, {10, 20}}));
    EXPECT_DOUBLE_EQ(capital.min.y, 17);
    EXPECT_DOUBLE_EQ(capital.max.y, 20);
    EXPECT_GT(capital.min.x, 10);
    EXPECT_LT(capital.max.x, 10 + lettering_width_mm("H", 3));
}

TEST(Lettering, WidthsAddUp) {
    double sum = 0;
    std::string text;
    for (const std::string& letter : kPromised) {
        sum += lettering_width_mm(letter, 2);
        text += letter;
    }
    EXPECT_NEAR(lettering_width_mm(text, 2), sum, 1e-9);
    EXPECT_NEAR(lettering_width_mm(text, 6), 3 * sum, 1e-9);
}

TEST(Lettering, AnchorsAreItsStartMiddleAndEnd) {
    const double width = lettering_width_mm("cherry", 2);
    const Path start = lettering("cherry", {2, Anchor::start, {50, 5}});
    const Path middle = lettering("cherry", {2, Anchor::middle, {50, 5}});
    const Path end = lettering("cherry", {2, Anchor::end, {50, 5}});
    for (std::size_t i = 0; i < start.points.size(); ++i) {
        EXPECT_NEAR(start.points[i].x - middle.points[i].x, width / 2, 1e-9);
        EXPECT_NEAR(start.points[i].x - end.points[i].x, width, 1e-9);
        EXPECT_EQ(start.points[i].y, end.points[i].y);
    }
}

// Letters stay within their line of twice the size, and nearly within their own width: neighbours
// don't run into each other.
TEST(Lettering, LettersKeepToTheirPlace) {
    constexpr double kSize = 20;
    for (const std::string& letter : kPromised) {
        const Bounds ink = bounds(lettering(letter, {kSize, Anchor::start, {0, 0}}));
        EXPECT_GE(ink.min.y, -1.15 * kSize) << letter;
        EXPECT_LE(ink.max.y, 0.35 * kSize) << letter;
        EXPECT_GE(ink.min.x, 0) << letter;
        EXPECT_LE(ink.max.x, lettering_width_mm(letter, kSize)) << letter;
    }
}

// Where the pen runs from one cubic into the next, its heading does not jump.
TEST(Lettering, CurvesAreSmooth) {
    std::size_t joins = 0;
    for (const std::string& letter : kPromised) {
        const Path path = lettering(letter, {20, Anchor::start, {0, 0}});
        const Vec2* p = path.points.data();
        for (std::size_t i = 0; i < path.verbs.size(); ++i) {
            const bool joined =
                i > 0 && path.verbs[i] == Verb::cubic && path.verbs[i - 1] == Verb::cubic;
            if (joined) {
                const Vec2 in = glm::normalize(p[-1] - p[-2]), out = glm::normalize(p[0] - p[-1]);
                EXPECT_NEAR(glm::dot(in, out), 1, 1e-9) << letter;
                ++joins;
            }
            p += path.verbs[i] == Verb::cubic ? 3 : 1;
        }
    }
    EXPECT_GT(joins, 60U);
}

// Between an upright and a level heading runs a quarter of an ellipse: at 45 degrees of its angle
// it is where the ellipse is (to 0.03 % of its size, as any cubic).
TEST(Lettering, QuartersAreEllipses) {
    const Path o = lettering("O", {20, Anchor::start, {0, 0}});
    const Bounds ink = bounds(o);
    const Vec2 radius(ink.width() / 2, ink.height() / 2);
    for (std::size_t i = 0; i + 3 < o.points.size(); i += 3) {
        const Vec2* p = &o.points[i];
        const Vec2 middle = (p[0] + 3.0 * p[1] + 3.0 * p[2] + p[3]) / 8.0;
        const Vec2 off = (middle - ink.centre()) / radius;
        EXPECT_NEAR(glm::length(off), 1, 3e-4);
    }
}

TEST(Lettering, KeepsTheContract) {
    std::string text;
    for (const std::string& letter : kPromised)
        text += letter;
    for (const double size : {0.5, 2.0, 30.0}) {
        Drawing drawing;
        drawing.width_mm = lettering_width_mm(text, size) + 2 * size;
        drawing.height_mm = 3 * size;
        Layer layer{"Captions", {}, {}};
        layer.paint.stroke = Colour{0, 0, 0};
        layer.paint.stroke_width_mm = lettering_pen_mm(size);
        layer.children.emplace_back(
            Shape{"", lettering(text, {size, Anchor::start, {size, 2 * size}}), {}});
        drawing.layers.push_back(std::move(layer));
        EXPECT_EQ(check(drawing), std::vector<std::string>{});
    }
}

}  // namespace
}  // namespace edaha
