// SPDX-License-Identifier: MIT
#include "ornament/rings.h"

#include <gtest/gtest.h>

#include "drawing/subpaths.h"
#include "geometry/measure.h"
#include "ornament/path_data.h"

namespace edaha {
namespace {

// Squares about (5, 5), clockwise to the eye or the other way.
std::string square(double half, bool clockwise = true) {
    const auto corner = [&](double x, double y) {
        return std::to_string(5 + half * x) + ' ' + std::to_string(5 + half * y) + ' ';
    };
    return clockwise ? 'M' + corner(-1, -1) + corner(1, -1) + corner(1, 1) + corner(-1, 1) + 'Z'
                     : 'M' + corner(-1, -1) + corner(-1, 1) + corner(1, 1) + corner(1, -1) + 'Z';
}

std::vector<double> areas(const Path& path) {
    std::vector<double> found;
    for (const Path& ring : subpaths(path))
        found.push_back(signed_area(ring));
    return found;
}

FillRings rings(const std::string& data, bool even_odd) {
    return fill_rings(read_path_data(data), even_odd);
}

using Areas = std::vector<double>;

TEST(FillRings, EvenOddNestingAlternatesWhateverTheDirections) {
    for (const bool outer : {true, false}) {
        for (const bool inner : {true, false}) {
            const FillRings r = rings(square(1) + square(4, outer) + square(2, inner), true);
            EXPECT_TRUE(r.is_exact);
            EXPECT_EQ(areas(r.path), (Areas{4, 64, -16}));
        }
    }
}

TEST(FillRings, NonZeroDropsRingsThatChangeNothing) {
    EXPECT_EQ(areas(rings(square(4) + square(2), false).path), (Areas{64}));
    EXPECT_EQ(areas(rings(square(4) + square(2, false), false).path), (Areas{64, -16}));
    EXPECT_EQ(areas(rings(square(4, false) + square(2), false).path), (Areas{64, -16}));
    EXPECT_EQ(areas(rings(square(4) + square(3) + square(2, false), false).path), (Areas{64}));
}

TEST(FillRings, SeparateRingsAreAllOutlines) {
    const FillRings r = rings("M0 0H1V1H0ZM5 0V1H6V0Z", false);
    EXPECT_TRUE(r.is_exact);
    EXPECT_EQ(areas(r.path), (Areas{1, 1}));
}

TEST(FillRings, CrossingRingsAreSaidToBeInexact) {
    const std::string cross = "M0 4H10V6H0ZM4 0H6V10H4Z";
    EXPECT_FALSE(rings(cross, true).is_exact);
    EXPECT_TRUE(rings(cross, false).is_exact);
    EXPECT_EQ(areas(rings(cross, false).path), (Areas{20, 20}));
    const std::string pentagram = "M50 0 79 90 2 35H98L21 90Z";
    EXPECT_FALSE(rings(pentagram, true).is_exact);
    EXPECT_TRUE(rings(pentagram, false).is_exact);
}

TEST(FillRings, ASingleRingIsTurnedToBeAnOutline) {
    EXPECT_EQ(areas(rings(square(1, false), false).path), (Areas{4}));
    EXPECT_EQ(areas(rings(square(1, false), true).path), (Areas{4}));
    EXPECT_TRUE(rings("M0 0L5 5", false).path.empty());
}

TEST(FillRings, TouchingRingsDoNotCross) {
    const FillRings r = rings("M0 0H8V8H0ZM0 0V4H4V0Z", true);
    EXPECT_TRUE(r.is_exact);
    EXPECT_EQ(areas(r.path), (Areas{64, -16}));
}

TEST(Tidy, SegmentsWithoutLengthGo) {
    const auto tidy = [](std::string_view data) {
        return without_short_segments(read_path_data(data), 1e-3);
    };
    EXPECT_EQ(tidy("M0 0L0 0L1 0L1 0.0001L1 1C1 1 1 1 1 1").points.size(), 3U);
    EXPECT_EQ(tidy("M0 0C3 0 0 3 0 0").points.size(), 4U);  // a loop has length
    EXPECT_TRUE(tidy("M5 5M6 6L6 6Z").empty());
    // A line back to the start, and an end that is nearly there.
    EXPECT_EQ(tidy("M0 0H1V1L0 0Z").verbs.size(), 4U);
    const Path snapped = tidy("M0 0H1C1 1 0 1 0.0001 0Z");
    EXPECT_EQ(snapped.points.back(), snapped.points.front());
}

TEST(Tidy, ManySmallStepsStayAWay) {
    std::string data = "M0 0";
    for (int i = 0; i < 1000; ++i)
        data += "l.0004 0";
    EXPECT_NEAR(length(without_short_segments(read_path_data(data), 1e-3)), .4, 1e-3);
}

TEST(Closed, EverySubpathIs) {
    const Path path = read_path_data("M0 0H1V1M5 5H6V6ZM8 8H9");
    EXPECT_FALSE(is_closed(path));
    EXPECT_TRUE(is_closed(closed(path)));
    EXPECT_EQ(closed(path).verbs.size(), path.verbs.size() + 2);
}

}  // namespace
}  // namespace edaha
