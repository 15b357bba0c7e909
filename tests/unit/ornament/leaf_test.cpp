// SPDX-License-Identifier: MIT
#include "ornament/leaf.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/measure.h"
#include "read_leaf_file.h"

namespace edaha {
namespace {

// A drawing 10 by 10 around `inside`, so that one unit stays one: a spine from (0, 0) to (0, 10),
// whose bottom is the stem. Shapes are moved by (0, -10).
LeafImport read_unscaled(const std::string& inside, const std::string& head = "") {
    const LeafImport import = read_leaf(
        "<svg xmlns='http://www.w3.org/2000/svg' " + head + ">" + inside +
            "<circle id='stem' cx='0' cy='10' r='1'/>"
            "<path class='x' fill='none' stroke='#000' stroke-width='.01' d='M0 0V10'/></svg>",
        "leaf.svg");
    EXPECT_EQ(breaches(import.leaf), "");
    return import;
}

// The first shape's box, "min.x,min.y max.x,max.y", back in the drawing's units.
std::string box_of(const std::string& inside, const std::string& head = "") {
    const LeafImport import = read_unscaled(inside, head);
    const Bounds box = bounds(import.leaf.shapes.front().path);
    char text[100];
    const auto round = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };
    snprintf(text, sizeof text, "%.6g,%.6g %.6g,%.6g", round(box.min.x), round(box.min.y + 10),
             round(box.max.x), round(box.max.y + 10));
    return text;
}

Paint paint_of(const std::string& inside) {
    return read_unscaled(inside).leaf.shapes.front().paint;
}

std::string inks_of(const std::string& inside) {
    const std::string all = inks(read_unscaled(inside).leaf);
    return all.substr(0, all.rfind(','));
}

Leaf read(const std::string& inside) {
    const LeafImport import = read_leaf("<svg>" + inside + "</svg>", "folder/name.of.leaf.svg");
    EXPECT_EQ(breaches(import.leaf), "");
    EXPECT_EQ(lines(import.warnings), "");
    return import.leaf;
}

const std::string kBlade = "<path d='M3 8C0 5 0 2 3 0C6 2 6 5 3 8Z'/>";

TEST(LeafFrame, WithoutStemTheBottomCentreIsTheOrigin) {
    const Leaf leaf = read(kBlade);
    EXPECT_EQ(leaf.name, "name.of.leaf");
    EXPECT_NEAR(leaf.box.min.y, -10, 1e-12);
    EXPECT_NEAR(leaf.box.max.y, 0, 1e-12);
    EXPECT_NEAR(leaf.box.centre().x, 0, 1e-12);
}

TEST(LeafFrame, TheStemIsTheOriginAndNotDrawn) {
    const Leaf leaf = read(kBlade + "<circle id='stem' cx='4' cy='7' r='.1'/>");
    ASSERT_EQ(leaf.shapes.size(), 1U);
    const double scale = 10.0 / 8;
    EXPECT_NEAR(leaf.box.max.y, 1 * scale, 1e-12);
    EXPECT_NEAR(leaf.box.height(), 10, 1e-12);
    EXPECT_NEAR(leaf.box.centre().x, -1 * scale, 1e-12);
}

TEST(LeafFrame, AStemMayBeAnythingWithAPlace) {
    for (const char* stem :
         {"<path id='stem' d='M4 7'/>", "<path id='stem' d='M3 6L5 8'/>",
          "<rect id='stem' x='3' y='6' width='2' height='2'/>",
          "<g id='stem' transform='translate(4 7)'><circle r='1'/></g>",
          "<circle id='stem' cx='4' cy='7'/>",
          "<g display='none'><circle id='stem' cx='4' cy='7' r='1'/></g>",
          "<defs><circle id='dot' r='1'/></defs><use id='stem' href='#dot' x='4' y='7'/>"}) {
        const Leaf leaf = read(kBlade + stem);
        EXPECT_NEAR(leaf.box.max.y, 10.0 / 8, 1e-12) << stem;
        EXPECT_EQ(leaf.shapes.size(), 1U) << stem;
    }
}

TEST(LeafFrame, AHangingFruitIsTurnedRound) {
    const Leaf leaf = read(kBlade + "<circle id='stem' cx='3' cy='0' r='1'/>");
    EXPECT_NEAR(leaf.box.min.y, -10, 1e-12);
    EXPECT_NEAR(leaf.box.max.y, 0, 1e-12);
    // Turned, not mirrored: a mark on the right is on the left.
    const Leaf marked = read(kBlade +
                             "<rect x='5' y='3' width='1' height='1' class='x'/>"
                             "<circle id='stem' cx='3' cy='0' r='1'/>");
    EXPECT_LT(bounds(marked.shapes[1].path).max.x, 0);
}

TEST(LeafFrame, BoxIncludesStrokesAndWidthScales) {
    const Leaf leaf = read("<path fill='none' stroke='#000' stroke-width='2' d='M5 0V20'/>");
    EXPECT_NEAR(leaf.shapes[0].paint.stroke_width_mm, 1, 1e-12);
    EXPECT_NEAR(leaf.box.width(), 1, 1e-12);
    EXPECT_NEAR(leaf.box.height(), 11, 1e-12);
}

TEST(LeafGeometry, BasicShapes) {
    EXPECT_EQ(box_of("<rect x='1' y='2' width='3' height='4'/>"), "1,2 4,6");
    EXPECT_EQ(box_of("<circle cx='5' cy='5' r='2'/>"), "3,3 7,7");
    EXPECT_EQ(box_of("<ellipse cx='5' cy='5' rx='2' ry='1'/>"), "3,4 7,6");
    EXPECT_EQ(box_of("<line x1='1' y1='2' x2='3' y2='4' stroke='#000'/>"), "1,2 3,4");
    EXPECT_EQ(box_of("<polyline points='1,2 3,4 5,2'/>"), "1,2 5,4");
    EXPECT_EQ(box_of("<polygon points='1,2 3,4 5,2'/>"), "1,2 5,4");
    EXPECT_EQ(box_of("<svg:rect xmlns:svg='x' x='1' y='2' width='3' height='4'/>"), "1,2 4,6");
}

TEST(LeafGeometry, RoundedCornersTakeTheirArea) {
    const auto area = [](const std::string& radii) {
        const std::string rect = "<rect x='1' y='2' width='4' height='6' " + radii + "/>";
        return signed_area(read_unscaled(rect).leaf.shapes.front().path);
    };
    const double corners = 4 - std::numbers::pi;
    EXPECT_NEAR(area(""), 24, 1e-12);
    EXPECT_NEAR(area("rx='1'"), 24 - corners, 2e-3);
    EXPECT_NEAR(area("ry='1'"), 24 - corners, 2e-3);
    EXPECT_NEAR(area("rx='1' ry='2'"), 24 - 2 * corners, 4e-3);
    EXPECT_NEAR(area("rx='99'"), std::numbers::pi * 6, 1e-2);  // an ellipse at most
    EXPECT_NEAR(area("rx='1' ry='0'"), 24, 1e-12);
}

TEST(LeafGeometry, UnitsAndPercentages) {
    EXPECT_EQ(box_of("<rect width='.75pt' height='1px'/>"), "0,0 1,1");
    EXPECT_EQ(box_of("<rect width='10%' height='20%'/>", "viewBox='5 5 30 20'"), "0,0 3,4");
    EXPECT_EQ(lines(read_unscaled("<rect width='10%' height='2'/>").warnings),
              "leaf.svg:1:55: rect width: '10%' is taken of the view box (leaves have no page)\n");
}

TEST(LeafGeometry, TransformsNest) {
    EXPECT_EQ(box_of("<g transform='translate(1 2)'><g transform='scale(2)'>"
                     "<rect width='1' height='2' transform='rotate(90)'/></g></g>"),
              "-3,2 1,4");
    const Paint paint = paint_of(
        "<g transform='scale(2 8)'><path d='M0 0H1' fill='none' "
        "stroke='#000' stroke-width='.5'/></g>");
    EXPECT_NEAR(paint.stroke_width_mm, 2, 1e-12);
}

TEST(LeafUse, CopiesAreMovedAndStyled) {
    const std::string dot = "<defs><rect id='r' width='1' height='2' class='x'/></defs>";
    EXPECT_EQ(box_of(dot + "<use href='#r' x='3' y='4'/>"), "3,4 4,6");
    EXPECT_EQ(box_of(dot + "<use xlink:href='#r' transform='scale(2)' x='1'/>"), "2,0 4,4");
    EXPECT_EQ(inks_of(dot + "<use href='#r' fill='#123456'/>"), "#123456/none");
    EXPECT_EQ(box_of(dot + "<g id='h'><use href='#r' x='1'/></g><use href='#h' y='1'/>"),
              "1,0 2,2");
}

TEST(LeafUse, SymbolsFitTheirViewBoxIntoTheUse) {
    const std::string symbol =
        "<symbol id='s' viewBox='10 10 4 2'>"
        "<rect x='10' y='10' width='4' height='2'/></symbol>";
    EXPECT_EQ(box_of(symbol + "<use href='#s' x='1' y='1' width='8' height='8'/>"), "1,3 9,7");
    EXPECT_EQ(box_of("<svg x='1' viewBox='0 0 2 2' width='4' height='4'>"
                     "<rect width='1' height='1'/></svg>"),
              "1,0 3,2");
}

TEST(LeafStyle, TheStrongerDeclarationWins) {
    const std::string sheet =
        "<style>path{fill:#111111}.a{fill:#222222}#i{fill:#333333}"
        ".loud{fill:#444444!important}</style>";
    const auto fill = [&](const std::string& attributes) {
        return ink_text(paint_of(sheet + "<g class='g' fill='#999999'><path d='M0 0H1V1Z' " +
                                 attributes + "/></g>")
                            .fill);
    };
    EXPECT_EQ(fill("class='b' fill='#000000'"), "#111111");
    EXPECT_EQ(fill("class='a'"), "#222222");
    EXPECT_EQ(fill("class='a' id='i'"), "#333333");
    EXPECT_EQ(fill("class='a' id='i' style='fill:#555555'"), "#555555");
    EXPECT_EQ(fill("class='loud' style='fill:#555555'"), "#444444");
    EXPECT_EQ(inks_of("<g class='g' fill='#999999'><rect width='1' height='1'/></g>"),
              "#999999/none");
    EXPECT_EQ(inks_of("<style><![CDATA[.c{fill:#abc}]]></style>"
                      "<rect class='c' width='1' height='1'/>"),
              "#aabbcc/none");
}

TEST(LeafStyle, TheLeafColourGoesWhereNoClassIs) {
    const std::string d = " d='M0 0H1V1Z'/>";
    EXPECT_EQ(inks_of("<path fill='#123456'" + d), "leaf/none");
    EXPECT_EQ(inks_of("<path class='recolour' fill='#123456'" + d), "leaf/none");
    EXPECT_EQ(inks_of("<path class='x recolour y' stroke='#ff0000'" + d), "leaf/#ff0000");
    EXPECT_EQ(inks_of("<path fill='none' stroke='#ff0000'" + d), "none/leaf");
    EXPECT_EQ(inks_of("<path class='x' fill='none' stroke='#ff0000'" + d), "none/#ff0000");
    EXPECT_EQ(inks_of("<path class='x' fill='currentColor' stroke='currentColor'" + d),
              "leaf/leaf");
    EXPECT_EQ(inks_of("<path class='x'" + d), "#000000/none");
    EXPECT_EQ(inks_of("<g class='x'><g><path fill='#123456'" + d + "</g></g>"), "#123456/none");
    EXPECT_EQ(inks_of("<g class='x'><path class='recolour'" + d + "</g>"), "leaf/none");
}

TEST(LeafStyle, OpacitiesMultiply) {
    const Paint paint = paint_of(
        "<g opacity='.5'><path opacity='.5' fill='#11111180' class='x' "
        "stroke='red' stroke-opacity='.5' fill-opacity='.5' "
        "d='M0 0H1V1Z'/></g>");
    EXPECT_NEAR(paint.fill_opacity, .125 * 128 / 255, 1e-6);
    EXPECT_NEAR(paint.stroke_opacity, .125, 1e-6);
}

TEST(LeafStyle, HiddenAndUnpaintedShapesAreLeftOut) {
    for (const char* hidden :
         {"display='none'", "style='display:none'", "visibility='hidden'", "fill='none'",
          "opacity='0'", "fill-opacity='0'", "fill='none' stroke='#000' stroke-width='0'"}) {
        const Leaf leaf = read(kBlade + "<path d='M0 0H1V1Z' " + hidden + "/>");
        EXPECT_EQ(leaf.shapes.size(), 1U) << hidden;
    }
    EXPECT_EQ(
        read("<g visibility='hidden'>" + kBlade + "<path visibility='visible' d='M0 0H1V1Z'/></g>")
            .shapes.size(),
        1U);
}

TEST(LeafStyle, OnePathWhereItCanTwoWhereItMust) {
    const std::string both = " class='x' fill='#111111' stroke='#222222' ";
    EXPECT_EQ(inks_of("<path" + both + "d='M0 0H1V1Z'/>"), "#111111/#222222");
    EXPECT_EQ(inks_of("<path" + both + "d='M0 0H1V1'/>"), "#111111/none, none/#222222");
    EXPECT_EQ(inks_of("<path" + both + "d='M0 0H1V1Z' paint-order='stroke fill'/>"),
              "none/#222222, #111111/none");
}

TEST(LeafStyle, SwatchesAreColoursAndOptionalValuesAreSkipped) {
    const std::string gradient =
        "<linearGradient id='a'><stop stop-color='#808080' "
        "stop-opacity='.5'/></linearGradient>"
        "<linearGradient id='b' href='#a'/>";
    const LeafImport import = read_unscaled(
        gradient +
        "<path class='x' fill='url(#b)' d='M0 0H1V1Z'/>"
        "<path class='x' style='fill:#123;fill:color(display-p3 0 1 0)' d='M0 0H1V1Z'/>");
    EXPECT_EQ(inks(import.leaf), "#808080/none, #112233/none, none/#000000");
    EXPECT_EQ(import.leaf.shapes[0].paint.fill_opacity, .5F);
    EXPECT_EQ(lines(import.warnings), "");
}

TEST(LeafFill, EvenOddBecomesNonZero) {
    const std::string ring = "d='M0 0H8V8H0ZM2 2H6V6H2Z'/>";
    const auto area = [&](const std::string& path) {
        return signed_area(read_unscaled(path).leaf.shapes.front().path);
    };
    EXPECT_NEAR(area("<path fill-rule='evenodd' " + ring), 48, 1e-12);
    EXPECT_NEAR(area("<path " + ring), 64, 1e-12);
}

TEST(LeafText, ByteOrderMarkAndLatin1AreRead) {
    EXPECT_EQ(read_leaf("\xEF\xBB\xBF<svg>" + kBlade + "</svg>", "a").leaf.shapes.size(), 1U);
    try {
        read_leaf(
            "<?xml version='1.0' encoding='ISO-8859-1'?><svg><!--\xE4\xF6--><path d='x'/></svg>",
            "a");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "a:1:67: path d: 'x' is not a command (expected one of M Z L H V "
                     "C S Q T A)");
    }
}

}  // namespace
}  // namespace edaha
