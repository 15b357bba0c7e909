// SPDX-License-Identifier: MIT
#include "ornament/svg_values.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ornament/scan.h"

namespace edaha::svg {
namespace {

template <typename Read>
std::string fault(Read&& read, std::string_view text) {
    try {
        read(text);
        return "no fault";
    } catch (const SyntaxError& error) {
        return fmt::format("{}: {}", error.offset(), error.what());
    }
}

void expect_near(Vec2 p, Vec2 q) {
    EXPECT_NEAR(p.x, q.x, 1e-12);
    EXPECT_NEAR(p.y, q.y, 1e-12);
}

TEST(SvgLength, UnitsAreOfThe96thOfAnInch) {
    EXPECT_EQ(read_length(" 7 ").value, 7);
    EXPECT_EQ(read_length("7px").value, 7);
    EXPECT_EQ(read_length("1in").value, 96);
    EXPECT_EQ(read_length("3pt").value, 4);
    EXPECT_EQ(read_length("2pc").value, 32);
    EXPECT_DOUBLE_EQ(read_length("25.4mm").value, 96);
    EXPECT_DOUBLE_EQ(read_length("2.54cm").value, 96);
    EXPECT_TRUE(read_length("50%").percent);
    EXPECT_EQ(fault(read_length, "2em"),
              "1: 'em' is not a unit (expected mm, cm, in, pt, pc or px)");
    EXPECT_EQ(fault(read_length, ""), "0: '' is not a length (expected a number)");
    EXPECT_EQ(fault(read_length, "1 2"), "2: '2' is too much (expected one length)");
}

TEST(SvgTransform, EachKindMovesAPointAsItSays) {
    expect_near(transform(read_transform("matrix(1 2 3 4 5 6)"), {1, 1}), {9, 12});
    expect_near(transform(read_transform("translate(3)"), {1, 1}), {4, 1});
    expect_near(transform(read_transform("translate(3,-2)"), {1, 1}), {4, -1});
    expect_near(transform(read_transform("scale(3)"), {1, 2}), {3, 6});
    expect_near(transform(read_transform("scale(3 -1)"), {1, 2}), {3, -2});
    expect_near(transform(read_transform("rotate(90)"), {1, 0}), {0, 1});
    expect_near(transform(read_transform("rotate(90 1 1)"), {2, 1}), {1, 2});
    expect_near(transform(read_transform("rotate(-720090)"), {1, 0}), {0, -1});
    expect_near(transform(read_transform("skewX(45)"), {0, 1}), {1, 1});
    expect_near(transform(read_transform("skewY(45)"), {1, 0}), {1, 1});
}

TEST(SvgTransform, TheLastOfAListComesFirst) {
    expect_near(transform(read_transform("translate(1,0)scale(2)"), {1, 0}), {3, 0});
    expect_near(transform(read_transform(" scale(2) , translate( 1 , 0 ) "), {1, 0}), {4, 0});
    expect_near(transform(read_transform(""), {1, 2}), {1, 2});
    expect_near(transform(read_transform("none"), {1, 2}), {1, 2});
}

TEST(SvgTransform, FaultsSayWhat) {
    EXPECT_EQ(fault(read_transform, "scale(1 2 3)"), "0: 'scale' has 3 numbers (expected 1 or 2)");
    EXPECT_EQ(fault(read_transform, "rotate()"), "0: 'rotate' has 0 numbers (expected 1 or 3)");
    EXPECT_EQ(fault(read_transform, "scale(1"),
              "7: the end is not a number (expected numbers and a closing parenthesis)");
    EXPECT_EQ(fault(read_transform, "rotate(45deg)"),
              "9: 'deg' is not a number (expected numbers and a closing parenthesis)");
    EXPECT_EQ(fault(read_transform, "perspective(3)"),
              "0: 'perspective' is not a transform (expected matrix, translate, scale, rotate, "
              "skewX or skewY)");
}

TEST(SvgColour, EverySyntaxOfOneColour) {
    const Colour green{0x33, 0x99, 0x66};
    for (const char* text :
         {"#396", "#339966", "rgb(51,153,102)", "rgb( 51 153 102 )", "rgb(20%, 60%, 40%)",
          "RGBA(51,153,102,1)", "#396f", "#339966ff", " #339966 icc-color(cmyk, 1, 0, 1, 0)"}) {
        EXPECT_EQ(read_colour(text).colour, green) << text;
        EXPECT_EQ(read_colour(text).opacity, 1) << text;
    }
    EXPECT_EQ(read_colour("rgb(300,-5,1.6)").colour, (Colour{255, 0, 2}));
    EXPECT_EQ(read_colour("rgba(1,2,3,.25)").opacity, .25);
    EXPECT_EQ(read_colour("rgb(1 2 3 / 25%)").opacity, .25);
    EXPECT_EQ(read_colour("#33996680").opacity, 128 / 255.0);
    EXPECT_EQ(read_colour("OldLace").colour, (Colour{253, 245, 230}));
}

TEST(SvgPaint, KindsAreToldApart) {
    EXPECT_EQ(read_paint("none").kind, SvgPaint::Kind::none);
    EXPECT_EQ(read_paint("transparent").kind, SvgPaint::Kind::none);
    EXPECT_EQ(read_paint("currentColor").kind, SvgPaint::Kind::current);
    EXPECT_EQ(read_paint("red").kind, SvgPaint::Kind::colour);
    const SvgPaint paint = read_paint("url( '#g1' ) #f00");
    EXPECT_EQ(paint.kind, SvgPaint::Kind::reference);
    EXPECT_EQ(paint.reference, "g1");
    EXPECT_TRUE(paint.has_fallback);
    EXPECT_EQ(paint.colour.colour, (Colour{255, 0, 0}));
    EXPECT_FALSE(read_paint("url(#g1) none").has_fallback);
}

TEST(SvgValues, ListsAndReferences) {
    EXPECT_EQ(read_points("1,2 3,4\n5 6").size(), 3U);
    EXPECT_EQ(read_points("1-2").front(), Vec2(1, -2));
    EXPECT_EQ(read_opacity("40%"), .4);
    EXPECT_EQ(read_opacity("3"), 1);
    EXPECT_EQ(read_view_box("-1,-2 30 40").origin, Vec2(-1, -2));
    EXPECT_EQ(read_reference("#a"), "a");
    EXPECT_EQ(read_reference("url(\"#a\")"), "a");
    EXPECT_EQ(read_reference("other.svg#a"), std::nullopt);
    EXPECT_EQ(read_reference("#"), std::nullopt);
}

}  // namespace
}  // namespace edaha::svg
