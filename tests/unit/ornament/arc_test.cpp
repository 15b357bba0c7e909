// SPDX-License-Identifier: MIT
#include "ornament/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/measure.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

Path draw(const EllipseArc& arc) {
    Path path;
    path.move_to(arc.from);
    add_arc(path, arc);
    return path;
}

struct Deviation {
    double least = 1e9, most = -1e9;
};

// How far the path is off the unit circle, in units of `radius`.
Deviation deviation(const Path& path, Vec2 centre, double radius) {
    Deviation d;
    walk_path(path, [&](const PathSegment& segment) {
        for (int i = 0; i <= 1000; ++i) {
            const Vec2 p = eval(segment.curve, i / 1000.0) - centre;
            const double off = std::hypot(p.x, p.y) / radius - 1;
            d.least = std::min(d.least, off);
            d.most = std::max(d.most, off);
        }
    });
    return d;
}

// The largest error of a quarter circle with arms 4/3 tan(pi/8): the maximum over t of
// |B(t)| - 1, found here by evaluating the polynomial itself.
double quarter_error() {
    const double arm = 4.0 / 3.0 * std::tan(std::numbers::pi / 8);
    double most = 0;
    for (int i = 0; i <= 100'000; ++i) {
        const double t = i / 1e5, u = 1 - t;
        const double x = u * u * u + 3 * u * u * t + 3 * u * t * t * arm;
        const double y = 3 * u * u * t * arm + 3 * u * t * t + t * t * t;
        most = std::max(most, std::hypot(x, y) - 1);
    }
    return most;
}

TEST(EllipseArc, AQuarterIsOffTheCircleByTheCubicsKnownError) {
    const Path path = draw({{13, 4}, {10, 7}, {3, 3}, 0, false, true});
    EXPECT_EQ(path.verbs.size(), 2U);
    const Deviation off = deviation(path, {10, 4}, 3);
    EXPECT_NEAR(off.most, quarter_error(), 1e-6);
    EXPECT_NEAR(off.most, 2.7253e-4, 1e-7);  // as it is usually quoted
    EXPECT_GT(off.least, -1e-12);
}

TEST(EllipseArc, FlagsChooseAmongTheFourArcs) {
    // From (1, 0) to (0, 1) on a unit circle about (0, 0) or (1, 1); y points down.
    const double quarter = std::numbers::pi / 2;
    for (const bool large : {false, true}) {
        for (const bool sweep : {false, true}) {
            const Path path = draw({{1, 0}, {0, 1}, {1, 1}, 0, large, sweep});
            const Vec2 centre = large == sweep ? Vec2(1, 1) : Vec2(0, 0);
            EXPECT_LT(deviation(path, centre, 1).most, 3e-4) << large << sweep;
            EXPECT_GT(deviation(path, centre, 1).least, -1e-12) << large << sweep;
            EXPECT_NEAR(length(path), quarter * (large ? 3 : 1), 1e-3) << large << sweep;
        }
    }
}

TEST(EllipseArc, TooSmallRadiiGrowUntilTheyReach) {
    const Path path = draw({{0, 0}, {10, 0}, {1, 1}, 0, false, true});
    const Deviation off = deviation(path, {5, 0}, 5);
    EXPECT_LT(off.most, 3e-4);
    EXPECT_GT(off.least, -1e-12);
    EXPECT_LT(path.points[3].y, 0);  // sweep: from +x to +y, so over the top
}

TEST(EllipseArc, TheEllipseTurnsWithItsAxis) {
    // A whole ellipse of two halves, 4 by 2, its long axis at 30 degrees.
    const double angle = std::numbers::pi / 6;
    const Vec2 end(4 * std::cos(angle), 4 * std::sin(angle));
    Path path = draw({-end, end, {4, 2}, 30, false, true});
    add_arc(path, {end, -end, {4, 2}, 30, false, true});
    path.close();
    EXPECT_NEAR(signed_area(path) / (std::numbers::pi * 8), 1, 3e-4);
    walk_path(path, [&](const PathSegment& segment) {
        const Vec2 p = segment.curve.p3;
        const double along = p.x * std::cos(angle) + p.y * std::sin(angle);
        const double across = p.y * std::cos(angle) - p.x * std::sin(angle);
        EXPECT_NEAR(along * along / 16 + across * across / 4, 1, 1e-12);
    });
}

TEST(EllipseArc, WithoutRadiusItIsALineAndWithoutChordNothing) {
    EXPECT_EQ(draw({{0, 0}, {1, 1}, {0, 5}, 0, false, true}).verbs.back(), Verb::line);
    EXPECT_EQ(draw({{1, 1}, {1, 1}, {5, 5}, 0, true, true}).verbs.size(), 1U);
}

}  // namespace
}  // namespace edaha
