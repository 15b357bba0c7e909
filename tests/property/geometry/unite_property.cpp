// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/measure.h"
#include "geometry/unite.h"
#include "geometry/walk_path.h"
#include "shapes.h"

namespace edaha {
namespace {

using Paths = std::vector<Path>;

constexpr double kGrid = UniteParams{}.grid;

// Boxes with whole corners, some the wrong way round.
Path any_box() {
    const int x = *rc::gen::inRange(0, 20), y = *rc::gen::inRange(0, 20);
    const int width = *rc::gen::inRange(1, 8), height = *rc::gen::inRange(1, 8);
    const Path box = shapes::box(x, y, x + width, y + height);
    return *rc::gen::arbitrary<bool>() ? box : reversed(box);
}

// Polygons that cross themselves, corners on halves.
Path any_polygon() {
    Path path;
    const int corners = *rc::gen::inRange(3, 8);
    for (int i = 0; i < corners; ++i) {
        const Vec2 p{*rc::gen::inRange(0, 40) * 0.5, *rc::gen::inRange(0, 40) * 0.5};
        path.empty() ? path.move_to(p) : path.line_to(p);
    }
    path.close();
    return path;
}

Path any_circle() {
    return shapes::circle({*rc::gen::inRange(0, 200) * 0.1, *rc::gen::inRange(0, 200) * 0.1},
                          *rc::gen::inRange(5, 60) * 0.1);
}

Path any_blob() {
    const auto point = [] {
        return Vec2{*rc::gen::inRange(0, 400) * 0.05, *rc::gen::inRange(0, 400) * 0.05};
    };
    Path path;
    path.move_to(point());
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
        const Vec2 a = point(), b = point();
        path.cubic_to(a, b, point());
    }
    path.close();
    return path;
}

Paths several(Path (*any)(), int most) {
    Paths paths;
    for (int i = *rc::gen::inRange(1, most); i > 0; --i)
        paths.push_back(any());
    return paths;
}

Paths several_of_all() {
    Paths paths;
    for (const auto& some : {several(any_box, 4), several(any_polygon, 3), several(any_circle, 4),
                             several(any_blob, 3)}) {
        paths.insert(paths.end(), some.begin(), some.end());
    }
    return paths;
}

bool same(const Path& a, const Path& b) {
    return a.verbs == b.verbs && a.points == b.points;
}

struct Rings {
    std::vector<std::vector<Cubic>> rings;
    bool closed = true;
};

Rings rings_of(const Path& path) {
    Rings result;
    bool open = false;
    walk_path(path, [&](const PathSegment& segment) {
        if (segment.verb == Verb::move) {
            result.closed = result.closed && !open;
            open = true;
            result.rings.emplace_back();
            return;
        }
        if (segment.verb == Verb::close) open = false;
        if (segment.verb == Verb::close && segment.curve.p0 == segment.curve.p3) return;
        result.rings.back().push_back(segment.curve);
    });
    result.closed = result.closed && !open;
    return result;
}

RC_GTEST_PROP(UniteProperty, AreaLiesBetweenTheLargestAndTheSum, ()) {
    const Paths paths = several_of_all();
    double largest = 0, sum = 0;
    for (const Path& path : paths) {
        const double area = area_of_union(std::span(&path, 1), 0.002);
        largest = std::max(largest, area);
        sum += area;
    }
    const double area = area_of_union(paths, 0.002);
    RC_ASSERT(area >= largest * (1 - 1e-3) - 1e-3);
    RC_ASSERT(area <= sum * (1 + 1e-3) + 1e-3);
}

RC_GTEST_PROP(UniteProperty, ThePathsAreaIsTheUnions, ()) {
    const Paths paths = several_of_all();
    const double area = area_of_union(paths, 5e-4);
    RC_ASSERT(std::abs(signed_area(unite(paths)) - area) <= 1e-3 * area + 5e-3);
}

RC_GTEST_PROP(UniteProperty, OrderChangesNoByte, ()) {
    Paths paths = several_of_all();
    const Path result = unite(paths);
    const std::size_t first = *rc::gen::inRange<std::size_t>(0, paths.size());
    std::rotate(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(first), paths.end());
    RC_ASSERT(same(unite(paths), result));
    std::reverse(paths.begin(), paths.end());
    RC_ASSERT(same(unite(paths), result));
}

RC_GTEST_PROP(UniteProperty, OfAUnionIsTheUnion, ()) {
    const Path once = unite(several(any_box, 12));
    RC_ASSERT(same(unite(std::span(&once, 1)), once));
}

RC_GTEST_PROP(UniteProperty, OfAUnionOfCurvesIsNearlyTheUnion, ()) {
    const Path once = unite(several_of_all());
    const Path again = unite(std::span(&once, 1));
    RC_ASSERT(std::abs(signed_area(again) - signed_area(once)) <= 5e-4 * signed_area(once) + 2e-3);
}

RC_GTEST_PROP(UniteProperty, MovingBoxesByGridStepsMovesTheResult, ()) {
    Paths paths = several(any_box, 12);
    Path result = unite(paths);
    const Affine moved(1, 0, 0, 1, *rc::gen::inRange(-100000, 100000) * kGrid,
                       *rc::gen::inRange(-100000, 100000) * kGrid);
    for (Path& path : paths)
        path = transformed(moved, path);
    RC_ASSERT(same(unite(paths), transformed(moved, result)));
}

RC_GTEST_PROP(UniteProperty, RingsOfPolygonsAreClosedAndDontCross, ()) {
    const Path path = unite(several(any_polygon, 5));
    const Rings rings = rings_of(path);
    RC_ASSERT(rings.closed);
    RC_ASSERT(shapes::lines_dont_cross(path));
}

RC_GTEST_PROP(UniteProperty, RingsAreClosedAndHaveNoEmptySegments, ()) {
    const Rings rings = rings_of(unite(several_of_all()));
    RC_ASSERT(rings.closed);
    for (const auto& ring : rings.rings) {
        RC_ASSERT(!ring.empty());
        RC_ASSERT(ring.front().p0 == ring.back().p3);
        for (const Cubic& c : ring)
            RC_ASSERT(c.p0 != c.p3 || c.p0 != c.p1);
    }
}

}  // namespace
}  // namespace edaha
