// SPDX-License-Identifier: MIT
#include "drawing/check.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/sample_drawing.h"

namespace edaha {
namespace {

using Lines = std::vector<std::string>;

Path square(double x, double y, double side) {
    Path path;
    path.move_to({x, y}), path.line_to({x + side, y}), path.line_to({x + side, y + side});
    path.line_to({x, y + side}), path.close();
    return path;
}

Path square_hole(double x, double y, double side) {
    Path path;
    path.move_to({x, y}), path.line_to({x, y + side}), path.line_to({x + side, y + side});
    path.line_to({x + side, y}), path.close();
    return path;
}

Path joined(Path a, const Path& b) {
    a.verbs.insert(a.verbs.end(), b.verbs.begin(), b.verbs.end());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    return a;
}

// One filled shape, "a", on a page of 100 x 100 mm, with one symbol.
Drawing one_shape(const Path& path) {
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = 100;
    drawing.symbols = {{"leaf", {{"", square(0, 0, 10), {}}}}};
    Layer layer{"Wood", {}, {Shape{"a", path, {}}}};
    layer.paint.fill = Colour{9, 9, 9};
    drawing.layers = {layer};
    return drawing;
}

Shape& shape_of(Drawing& drawing) {
    return std::get<Shape>(drawing.layers[0].children[0]);
}

Lines check_path(const Path& path) {
    return check(one_shape(path));
}

Lines check_use(const Affine& map, std::uint32_t symbol = 0) {
    Drawing drawing = one_shape(square(0, 0, 100));
    drawing.layers[0].children.push_back(Use{symbol, map, {}});
    return check(drawing);
}

TEST(Check, TheSamplesKeepTheContract) {
    EXPECT_EQ(check(test::sample_drawing()), Lines{});
    EXPECT_EQ(check(test::field_drawing(500, 500)), Lines{});
    EXPECT_EQ(check_path(square(0, 0, 100)), Lines{});
}

TEST(Check, PageNeedsASize) {
    EXPECT_EQ(check(Drawing{}), Lines{"page: its size is 0 x 0 mm"});
}

TEST(Check, PointsAreFinite) {
    Path path = square(1, 1, 5);
    path.points[2].y = std::nan("");
    EXPECT_EQ(check_path(path), Lines{"layer 'Wood', shape 'a': point (6, nan) is not finite"});
}

TEST(Check, VerbsAndPointsAgree) {
    Path path = square(1, 1, 5);
    path.points.pop_back();
    EXPECT_EQ(check_path(path),
              Lines{"layer 'Wood', shape 'a': its verbs take 4 points, it has 3"});
    path.verbs.erase(path.verbs.begin());
    EXPECT_EQ(check_path(path),
              Lines{"layer 'Wood', shape 'a': a subpath does not start with move"});
    EXPECT_EQ(check_path({}), Lines{"layer 'Wood', shape 'a': the path is empty"});
}

TEST(Check, SubpathsHaveSegmentsWithALength) {
    Path moves;
    moves.move_to({1, 1});
    EXPECT_EQ(check_path(moves), Lines{"layer 'Wood', shape 'a': a subpath has no segment"});
    Path still = square(1, 1, 5);
    still.points[2] = still.points[1] + Vec2(0, kShortestSegment_mm / 2);
    EXPECT_EQ(check_path(still),
              Lines{"layer 'Wood', shape 'a': the segment at (6, 1) has no length"});
    Path loop;  // comes back to where it started, but not at once
    loop.move_to({10, 10}), loop.cubic_to({20, 10}, {10, 20}, {10, 10}), loop.close();
    EXPECT_EQ(check_path(loop), Lines{});
}

TEST(Check, FilledSubpathsAreClosed) {
    Path path = joined(square(1, 1, 5), square(20, 1, 5));
    path.verbs.pop_back();
    EXPECT_EQ(check_path(path),
              Lines{"layer 'Wood', shape 'a': subpath 2 is filled but not closed"});
    Drawing stroked = one_shape(path);
    stroked.layers[0].paint.fill = Ink::none();
    EXPECT_EQ(check(stroked), Lines{});
}

TEST(Check, CompoundPathsStartWithAnOutline) {
    EXPECT_EQ(check_path(joined(square(1, 1, 9), square_hole(2, 2, 3))), Lines{});
    EXPECT_EQ(check_path(square_hole(2, 2, 3)), Lines{});
    EXPECT_EQ(check_path(joined(square_hole(2, 2, 3), square(1, 1, 9))),
              Lines{"layer 'Wood', shape 'a': its first subpath is a hole: it runs anticlockwise"});
    EXPECT_EQ(check_path(joined(square(1, 1, 9), square_hole(12, 2, 3))),
              Lines{"layer 'Wood', shape 'a': subpath 2 is a hole outside the outlines before it"});
}

TEST(Check, EverythingIsInsideThePageWithItsStroke) {
    EXPECT_EQ(check_path(square(95, 1, 6)),
              Lines{"layer 'Wood', shape 'a': it reaches from (95.000001, 1.000001) to "
                    "(100.999999, 6.999999), outside the page"});
    Drawing drawing = one_shape(square(1, 1, 98));
    shape_of(drawing).paint.stroke = Colour{};
    shape_of(drawing).paint.stroke_width_mm = 2;
    EXPECT_EQ(check(drawing), Lines{});
    shape_of(drawing).paint.stroke_width_mm = 2.1;
    EXPECT_EQ(check(drawing).size(), 1u);
}

TEST(Check, CurvesMayHaveControlPointsOutside) {
    Path path;  // its top is at a quarter of the arms' height below the edge
    path.move_to({10, 3}), path.cubic_to({10, -1}, {20, -1}, {20, 3}), path.close();
    EXPECT_EQ(check_path(path), Lines{});
}

TEST(Check, InstancesAreInsideToo) {
    EXPECT_EQ(check_use(Affine(1, 0, 0, 1, 90, 0)), Lines{});
    EXPECT_EQ(check_use(Affine(1, 0, 0, 1, 91, 0)),
              Lines{"layer 'Wood', use 2: it reaches from (91.000001, 0.000001) to (100.999999, "
                    "9.999999), outside the page"});
    EXPECT_EQ(check_use(Affine(0, 1, -1, 0, 10, 0)), Lines{});  // turned by a right angle
}

TEST(Check, InstancesNameASymbolAndCanBeInverted) {
    EXPECT_EQ(check_use(Affine(1, 0, 0, 1, 0, 0), 1),
              Lines{"layer 'Wood', use 2: there is no symbol 1 (of 1)"});
    EXPECT_EQ(check_use(Affine(1, 2, 2, 4, 0, 0)),
              Lines{"layer 'Wood', use 2: its transform cannot be inverted"});
    EXPECT_EQ(check_use(Affine(std::nan(""), 0, 0, 1, 0, 0)),
              Lines{"layer 'Wood', use 2: its transform is not finite"});
}

TEST(Check, IdsAreUniqueNames) {
    Drawing drawing = one_shape(square(1, 1, 5));
    shape_of(drawing).id = "leaf";
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', shape 'leaf': the id 'leaf' is taken"});
    shape_of(drawing).id = "1st";
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', shape '1st': '1st' is not an id "
                                    "([A-Za-z][A-Za-z0-9._-]*)"});
    shape_of(drawing).id = "";
    drawing.layers[0].label = "";
    EXPECT_EQ(check(drawing), Lines{"layer '': '' is not an id ([A-Za-z][A-Za-z0-9._-]*)"});
}

TEST(Check, PaintIsInRange) {
    Drawing drawing = one_shape(square(1, 1, 5));
    shape_of(drawing).paint.stroke = Colour{};
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', shape 'a': its stroke has no width"});
    shape_of(drawing).paint.stroke_width_mm = -1;
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', shape 'a': its stroke's width is -1"});
    shape_of(drawing).paint.stroke_width_mm = 1;
    shape_of(drawing).paint.fill_opacity = 1.5f;
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', shape 'a': its opacity is 1.5"});
}

TEST(Check, DashesAreLengthsAndForShapesOnly) {
    Drawing drawing = one_shape(square(1, 1, 5));
    shape_of(drawing).paint.dash_mm = -1;
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', shape 'a': its dashes are -1 mm long"});
    Drawing sample = test::sample_drawing();
    Paint& paint = sample.layers[2].paint;
    paint.stroke = Colour{};
    paint.stroke_width_mm = paint.dash_mm = 0.1;
    EXPECT_NE(check(sample), Lines{});
    paint.dash_mm = 0;
    EXPECT_EQ(check(sample), Lines{});
}

TEST(Check, InstancesFillOnlyClosedShapes) {
    Drawing drawing = one_shape(square(0, 0, 100));
    drawing.symbols[0].shapes[0].path.verbs.pop_back();
    EXPECT_EQ(check(drawing), Lines{});
    for (int i = 0; i < 2; ++i)
        drawing.layers[0].children.push_back(Use{});
    EXPECT_EQ(check(drawing), Lines{"layer 'Wood', use 2: it fills subpath 1 of a shape of 'leaf', "
                                    "which is not closed"});
}

TEST(Check, AVeryBrokenDrawingIsNotListedWhole) {
    Drawing drawing = one_shape(square(1, 1, 5));
    for (int i = 0; i < 150; ++i)
        drawing.layers[0].children.push_back(Shape{});
    const Lines lines = check(drawing);
    ASSERT_EQ(lines.size(), kMostBreaches + 1);
    EXPECT_EQ(lines[0], "layer 'Wood', shape 2: the path is empty");
    EXPECT_EQ(lines.back(), "and 50 more");
}

}  // namespace
}  // namespace edaha
