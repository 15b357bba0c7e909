// SPDX-License-Identifier: MIT
#include "geometry/measure.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace edaha {
namespace {

TEST(SignedArea, OfPolygonsAndHoles) {
    Path path = shapes::box(100, 200, 110, 230);
    EXPECT_DOUBLE_EQ(signed_area(path), 300);
    EXPECT_DOUBLE_EQ(signed_area(reversed(path)), -300);
    shapes::append(path, reversed(shapes::box(102, 202, 104, 204)));
    EXPECT_DOUBLE_EQ(signed_area(path), 296);
}

TEST(SignedArea, IsExactForCubics) {
    Path cap;  // y = x (1 - x) over its chord: 1/6
    cap.move_to({0, 0});
    cap.cubic_to({1.0 / 3, 1.0 / 3}, {2.0 / 3, 1.0 / 3}, {1, 0});
    EXPECT_NEAR(signed_area(cap), -1.0 / 6, 1e-15);
    cap.close();
    EXPECT_NEAR(signed_area(transformed(Affine(2, 0, 0, 3, 1000, 0), cap)), -1, 1e-12);
}

TEST(SignedArea, OfACircle) {
    EXPECT_NEAR(signed_area(shapes::circle({5, 5}, 2, 16)), 4 * shapes::kPi, 1e-6);
}

TEST(Length, CountsTheClosingLine) {
    EXPECT_DOUBLE_EQ(length(shapes::box(0, 0, 3, 4)), 14);
    EXPECT_NEAR(length(shapes::circle({0, 0}, 1, 16)), 2 * shapes::kPi, 1e-6);
}

TEST(Transformed, MapsPointsAndKeepsVerbs) {
    const Path path = transformed(Affine(0, 1, -1, 0, 10, 0), shapes::box(0, 0, 1, 2));
    EXPECT_EQ(path.points[1], Vec2(10, 1));
    EXPECT_EQ(path.verbs, shapes::box(0, 0, 1, 2).verbs);
}

TEST(Reversed, TwiceIsTheSame) {
    Path path = shapes::circle({0, 0}, 1);
    shapes::append(path, shapes::box(0, 0, 1, 1));
    path.move_to({5, 5});
    path.line_to({6, 5});
    path.cubic_to({7, 5}, {8, 6}, {9, 9});
    const Path again = reversed(reversed(path));
    EXPECT_EQ(again.verbs, path.verbs);
    EXPECT_EQ(again.points, path.points);
}

TEST(Reversed, ClosedSubpathKeepsItsFirstPoint) {
    const Path path = reversed(shapes::polygon({{0, 0}, {1, 0}, {1, 1}}));
    ASSERT_EQ(path.points.size(), 3u);
    EXPECT_EQ(path.points[0], Vec2(0, 0));
    EXPECT_EQ(path.points[1], Vec2(1, 1));
    EXPECT_EQ(path.verbs.back(), Verb::close);
}

}  // namespace
}  // namespace edaha
