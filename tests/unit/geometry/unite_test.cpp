// SPDX-License-Identifier: MIT
#include "geometry/unite.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "geometry/measure.h"
#include "geometry/walk_path.h"
#include "shapes.h"

namespace edaha {
namespace {

using shapes::box;
using shapes::circle;
using shapes::kPi;

Path united(std::vector<Path> paths, const UniteParams& params = {}) {
    return unite(paths, params);
}

std::size_t count(const Path& path, Verb verb) {
    return static_cast<std::size_t>(std::count(path.verbs.begin(), path.verbs.end(), verb));
}

bool same(const Path& a, const Path& b) {
    return a.verbs == b.verbs && a.points == b.points;
}

// Every ring closed, no segment without length, outlines before holes.
void expect_sound(const Path& path) {
    EXPECT_EQ(count(path, Verb::move), count(path, Verb::close));
    bool holes = false;
    Path ring;
    walk_path(path, [&](const PathSegment& segment) {
        const Cubic& c = segment.curve;
        if (segment.verb == Verb::move) ring = Path{};
        if (segment.verb == Verb::move) ring.move_to(c.p0);
        if (segment.verb == Verb::line) ring.line_to(c.p3);
        if (segment.verb == Verb::cubic) ring.cubic_to(c.p1, c.p2, c.p3);
        if (segment.verb == Verb::line || segment.verb == Verb::cubic) {
            EXPECT_GT(arc_length(c), 0);
        }
        if (segment.verb != Verb::close) return;
        const double area = signed_area(ring);
        EXPECT_NE(area, 0);
        EXPECT_TRUE(!holes || area < 0);
        holes = holes || area < 0;
    });
}

double lens(double radius, double distance) {
    const double d = distance;
    return 2 * radius * radius * std::acos(d / (2 * radius)) -
           d / 2 * std::sqrt(4 * radius * radius - d * d);
}

TEST(Unite, NothingGivesNothing) {
    EXPECT_TRUE(united({}).empty());
    EXPECT_TRUE(united({Path{}}).empty());
    EXPECT_EQ(area_of_union({}, 0.01), 0);
}

TEST(Unite, OfOneBoxIsTheBox) {
    EXPECT_TRUE(same(united({box(1, 2, 3, 4)}), box(1, 2, 3, 4)));
    EXPECT_TRUE(same(united({reversed(box(1, 2, 3, 4))}), box(1, 2, 3, 4)));
}

TEST(Unite, OfOneCircleKeepsItsCurves) {
    const Path whole = circle({10, 10}, 4);
    const Path result = united({whole});
    EXPECT_EQ(count(result, Verb::cubic), 4u);
    EXPECT_NEAR(signed_area(result), signed_area(whole), 1e-3);
}

TEST(Unite, TwoCirclesHaveTheAnalyticArea) {
    for (const double distance : {0.5, 4.0, 9.0, 9.99}) {
        const std::vector<Path> pair{circle({10, 10}, 5, 16), circle({10 + distance, 10}, 5, 16)};
        const double exact = 2 * kPi * 25 - lens(5, distance);
        const Path result = unite(pair);
        expect_sound(result);
        EXPECT_NEAR(signed_area(result), exact, exact * 1e-4);
        EXPECT_NEAR(area_of_union(pair, 0.002), exact, exact * 1e-4);
        EXPECT_LE(count(result, Verb::cubic), 34u);
        EXPECT_EQ(count(result, Verb::line), 0u);
    }
}

TEST(Unite, CrossingsLieOnTheCurves) {
    const Path result = united({circle({10, 10}, 5, 16), circle({14, 10}, 5, 16)});
    for (const Vec2 p : {Vec2(12, 10 - std::sqrt(21.0)), Vec2(12, 10 + std::sqrt(21.0))}) {
        const bool found = std::any_of(result.points.begin(), result.points.end(),
                                       [&](Vec2 q) { return glm::distance(p, q) < 5e-4; });
        EXPECT_TRUE(found);
    }
}

TEST(Unite, OverlappingSquaresInARow) {
    std::vector<Path> squares;
    for (int i = 0; i < 20; ++i)
        squares.push_back(box(i, 0, i + 1.5, 1.5));
    const Path result = unite(squares);
    EXPECT_TRUE(same(result, box(0, 0, 20.5, 1.5)));
    EXPECT_NEAR(area_of_union(squares, 0.01), 20.5 * 1.5, 1e-9);
}

TEST(Unite, CoincidentEdgesDisappear) {
    EXPECT_TRUE(same(united({box(0, 0, 1, 1), box(1, 0, 2, 1), box(0, 1, 2, 3), box(0, 0, 1, 1)}),
                     box(0, 0, 2, 3)));
}

TEST(Unite, OneShapeManyTimesIsThatShape) {
    const Path once = united({circle({7, 7}, 3)});
    EXPECT_TRUE(same(united(std::vector<Path>(50, circle({7, 7}, 3))), once));
    EXPECT_TRUE(same(united({circle({7, 7}, 3), reversed(circle({7, 7}, 3))}), once));
}

TEST(Unite, AnAnnulusKeepsItsHole) {
    Path ring = circle({10, 10}, 6, 16);
    shapes::append(ring, reversed(circle({10, 10}, 4, 16)));
    const Path result = united({ring});
    expect_sound(result);
    EXPECT_EQ(count(result, Verb::move), 2u);
    EXPECT_NEAR(signed_area(result), 20 * kPi, 1e-3);
    EXPECT_EQ(count(united({ring, circle({10, 10}, 5, 16)}), Verb::move), 1u);
}

TEST(Unite, InsidesOfOppositePathsDontCancel) {
    EXPECT_NEAR(signed_area(united({box(0, 0, 2, 2), reversed(box(1, 1, 3, 3))})), 7, 1e-12);
}

TEST(Unite, SubpathsThatOverlapAreFilledByTheNonZeroRule) {
    Path twice = box(0, 0, 2, 2);
    shapes::append(twice, box(1, 1, 3, 3));
    EXPECT_NEAR(signed_area(united({twice})), 7, 1e-12);
    Path cut = box(0, 0, 2, 2);
    shapes::append(cut, reversed(box(1, 1, 3, 3)));
    EXPECT_NEAR(signed_area(united({cut})), 6, 1e-12);  // what winds +1 - 1 is outside
}

TEST(Unite, AFigureEightHasTwoRings) {
    const Path eight = shapes::polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    const Path result = united({eight});
    expect_sound(result);
    EXPECT_EQ(count(result, Verb::move), 2u);
    EXPECT_NEAR(signed_area(result), 8, 1e-9);
}

TEST(Unite, TangentCirclesMayTouch) {
    const double exact = 2 * kPi * 25;
    for (const double off : {-1e-3, -1e-5, 0.0, 1e-5, 1e-3}) {
        const Path result = united({circle({5, 5}, 5, 16), circle({15 + off, 5}, 5, 16)});
        expect_sound(result);
        EXPECT_NEAR(signed_area(result), exact, exact * 1e-4);
    }
    const Path inside = united({circle({5, 5}, 5, 16), circle({7, 5}, 3, 16)});
    expect_sound(inside);
    EXPECT_NEAR(signed_area(inside), 25 * kPi, 25 * kPi * 1e-4);
    EXPECT_LE(count(inside, Verb::cubic), 18u);
}

TEST(Unite, NearlyCoincidentCirclesDontWeave) {
    for (const double off : {1e-4, 1e-3, 2e-3}) {
        const Path result = united({circle({5, 5}, 5, 8), circle({5 + off, 5}, 5, 8)});
        expect_sound(result);
        EXPECT_NEAR(signed_area(result), 25 * kPi, 25 * kPi * 1e-3);
        EXPECT_LE(count(result, Verb::cubic), 24u) << off;
    }
}

TEST(Unite, HolesFiveDeep) {
    std::vector<Path> frames;
    double exact = 0;
    for (int i = 0; i < 5; ++i) {
        const double a = 10 * i, b = 100 - 10 * i;
        Path frame = box(a, a, b, b);
        shapes::append(frame, reversed(box(a + 5, a + 5, b - 5, b - 5)));
        frames.push_back(frame);
        exact += (b - a) * (b - a) - (b - a - 10) * (b - a - 10);
    }
    const Path result = unite(frames);
    expect_sound(result);
    EXPECT_EQ(count(result, Verb::move), 10u);
    EXPECT_NEAR(signed_area(result), exact, 1e-9);
}

TEST(Unite, HolesBelowTheSmallestAreaAreFilled) {
    Path holed = box(0, 0, 10, 10);
    shapes::append(holed, reversed(box(4, 4, 4.02, 4.02)));
    EXPECT_EQ(count(united({holed}, {.min_area = 1e-3}), Verb::move), 1u);
    EXPECT_EQ(count(united({holed}, {.min_area = 1e-5}), Verb::move), 2u);
    EXPECT_TRUE(united({box(0, 0, 0.02, 0.02)}).empty());
}

TEST(Unite, ShapesWithoutInsideGiveNothing) {
    EXPECT_TRUE(united({shapes::polygon({{0, 0}, {5, 5}})}).empty());
    EXPECT_TRUE(united({shapes::polygon({{3, 3}, {3, 3}, {3, 3}})}).empty());
}

TEST(Unite, CoincidentCurvesGiveTheSameBytesInAnyOrder) {
    const Path whole = circle({7, 7}, 3), lid = box(6, 7.3, 12, 12);
    std::vector<Path> paths{whole, reversed(whole), circle({7, 7}, 3, 8), lid};
    const Path result = unite(paths);
    for (int i = 0; i < 4; ++i) {
        std::rotate(paths.begin(), paths.begin() + 1, paths.end());
        EXPECT_TRUE(same(unite(paths), result));
        EXPECT_TRUE(same(unite(std::vector<Path>(paths.rbegin(), paths.rend())), result));
    }
}

TEST(Unite, CrossingsBesideAJointLeaveNoSpeck) {
    // The circle's joint is at (15, 10); the box crosses it a micrometre further on.
    const Path result = united({circle({10, 10}, 5), box(12, 10.001, 20, 20)});
    expect_sound(result);
    walk_path(result, [](const PathSegment& segment) {
        EXPECT_TRUE(segment.verb != Verb::cubic || arc_length(segment.curve) > 0.002);
    });
}

TEST(Unite, StraightenedBordersDontCross) {
    // Two rings touch in a pixel that a line of one only passes: bent into its centre it touches
    // the other, drawn straight again it would cross it.
    const Path result = united({shapes::polygon({{9, 13}, {17, 9}, {2, 19}}),
                                shapes::polygon({{17, 11}, {19, 3}, {14, 18}, {2, 12}, {2, 7}})});
    expect_sound(result);
    EXPECT_TRUE(shapes::lines_dont_cross(result));
}

TEST(Unite, OutlinesThatWeaveAreFollowedOneAtATime) {
    // The same circle cut in different places: its chords cross each other hundreds of times.
    for (const int arcs : {6, 7, 9, 11}) {
        for (const double off : {0.0, 1e-3}) {
            const Path result = united({circle({5, 5}, 5, 8), circle({5 + off, 5}, 5, arcs)});
            expect_sound(result);
            EXPECT_LE(count(result, Verb::cubic), 20u);
            EXPECT_NEAR(signed_area(result), 25 * kPi, 25 * kPi * 1e-3);
        }
    }
}

// Round the loop between a curve and the closing line the border runs against its source: it is no
// outline that weaves.
TEST(Unite, LoopsThatTurnTheOtherWayKeepTheirArea) {
    Path path;
    path.move_to({6, 9.3});
    path.cubic_to({1.8, 7.8}, {6.8, 9.2}, {3.75, 7.45});
    path.cubic_to({0, 0}, {0.8, 0}, {3.9, 8.3});
    path.close();
    const Path result = unite(std::span(&path, 1));
    expect_sound(result);
    EXPECT_NEAR(signed_area(result), area_of_union(std::span(&path, 1), 1e-4), 2e-3);
}

TEST(Unite, HugeCoordinatesCoarsenTheGrid) {
    const Path result = united({box(0, 0, 3e6, 3e6), box(1e6, 1e6, 4e6, 4e6)});
    EXPECT_NEAR(signed_area(result), 14e12, 1e8);
}

TEST(Unite, AThousandSquaresCoverTheCountedCells) {
    // Corners on whole numbers: a raster of unit cells counts the union exactly.
    shapes::Random random;
    std::vector<Path> squares;
    std::vector<std::uint8_t> cells(300 * 300, 0);
    for (int i = 0; i < 1000; ++i) {
        const int x = static_cast<int>(random() * 280), y = static_cast<int>(random() * 280);
        const int side = 1 + static_cast<int>(random() * 12);
        squares.push_back(box(x, y, x + side, y + side));
        for (int j = 0; j < side; ++j) {
            std::fill_n(cells.begin() + (y + j) * 300 + x, side, std::uint8_t{1});
        }
    }
    const auto exact = static_cast<double>(std::count(cells.begin(), cells.end(), 1));
    const Path result = unite(squares);
    expect_sound(result);
    EXPECT_NEAR(signed_area(result), exact, 1e-6);
    EXPECT_NEAR(area_of_union(squares, 0.01), exact, 1e-6);
}

// A tapering limb along a circle's arc: two long flanks and two short ends.
Path limb(Vec2 foot, double angle, double length, double width) {
    const Vec2 u(std::cos(angle), std::sin(angle)), v(-u.y, u.x);
    const auto at = [&](double along, double side) {
        const double bend = 0.1 * along * along / length;
        return foot + u * along + v * (side + bend);
    };
    Path path;
    path.move_to(at(0, -width));
    path.cubic_to(at(length / 3, -width * 0.8), at(length * 2 / 3, -width * 0.5),
                  at(length, -width * 0.2));
    path.line_to(at(length, width * 0.2));
    path.cubic_to(at(length * 2 / 3, width * 0.5), at(length / 3, width * 0.8), at(0, width));
    path.close();
    return path;
}

// The area that paths cover together, by exact lengths on horizontal lines `step` apart.
double area_by_lines(const std::vector<Path>& paths, double low, double high, double step) {
    std::vector<std::vector<Vec2>> polygons;
    for (const Path& path : paths) {
        std::vector<Vec2>& polygon = polygons.emplace_back();
        walk_path(path, [&](const PathSegment& segment) {
            for (const Vec2 p : flatten(segment.curve, 1e-4))
                polygon.push_back(p);
        });
    }
    double area = 0;
    for (double y = low + step / 2; y < high; y += step) {
        std::vector<std::pair<double, double>> spans;
        for (const auto& polygon : polygons) {
            std::vector<double> xs;
            for (std::size_t i = 1; i < polygon.size(); ++i) {
                const Vec2 a = polygon[i - 1], b = polygon[i];
                if ((a.y < y) != (b.y < y)) {
                    xs.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
                }
            }
            std::sort(xs.begin(), xs.end());
            for (std::size_t i = 1; i < xs.size(); i += 2)
                spans.emplace_back(xs[i - 1], xs[i]);
        }
        std::sort(spans.begin(), spans.end());
        double reached = -1e300;
        for (const auto& [from, to] : spans) {
            area += step * std::max(0.0, to - std::max(from, reached));
            reached = std::max(reached, to);
        }
    }
    return area;
}

TEST(Unite, LimbsWithGrazingFlanksKeepTheirArea) {
    shapes::Random random;
    std::vector<Path> limbs;
    for (int i = 0; i < 200; ++i) {
        const Vec2 foot(100 + 20 * random(), 150 + 20 * random());
        const double angle = 0.1 * random(), length = 40 + 30 * random();
        limbs.push_back(limb(foot, angle, length, 1 + 2 * random()));
    }
    const Path result = unite(limbs);
    expect_sound(result);
    const double exact = area_by_lines(limbs, 140, 200, 0.02);
    EXPECT_NEAR(signed_area(result), exact, exact * 5e-4);
    EXPECT_NEAR(area_of_union(limbs, 0.005), exact, exact * 5e-4);
    EXPECT_TRUE(same(unite(std::vector<Path>(limbs.rbegin(), limbs.rend())), result));
}

}  // namespace
}  // namespace edaha
