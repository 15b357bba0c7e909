// SPDX-License-Identifier: MIT
#include "ornament/bark_drawing.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "style/catalogue.h"

namespace edaha {
namespace {

BarkTile tile_of(const std::string& content, const std::string& box = "viewBox='0 0 20 30'") {
    return read_bark("<svg xmlns='http://www.w3.org/2000/svg' " + box + ">" + content + "</svg>",
                     "t.svg")
        .tile;
}

std::string error_of(const std::string& svg) {
    try {
        read_bark(svg, "t.svg");
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(ReadBark, TakesStrokesAsTheyAre) {
    const BarkTile tile =
        tile_of("<path d='M2 25 L2 5' stroke='#222' stroke-width='0.5' fill='none'/>");
    EXPECT_EQ(tile.width_mm, 20);
    EXPECT_EQ(tile.height_mm, 30);
    ASSERT_EQ(tile.lines.size(), 1U);
    const BarkLine& line = tile.lines[0];
    EXPECT_FALSE(line.light);
    EXPECT_EQ(line.points.front(), Vec2(2, 5));  // y upwards
    EXPECT_EQ(line.points.back(), Vec2(2, 25));
    for (const double width : line.widths_mm)
        EXPECT_NEAR(width, 0.5, 1e-9);
}

TEST(ReadBark, FindsTheMiddleOfNarrowShapes) {
    // A spindle, upright, two wide in its middle.
    const BarkTile tile = tile_of("<path d='M10 5 Q12 15 10 25 Q8 15 10 5 Z' fill='#222'/>");
    ASSERT_EQ(tile.lines.size(), 1U);
    const BarkLine& line = tile.lines[0];
    double low = 30, high = 0, widest = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        EXPECT_NEAR(line.points[i].x, 10, 0.1);
        low = std::min(low, line.points[i].y), high = std::max(high, line.points[i].y);
        widest = std::max(widest, line.widths_mm[i]);
    }
    EXPECT_NEAR(low, 5, 0.6);
    EXPECT_NEAR(high, 25, 0.6);
    EXPECT_NEAR(widest, 2, 0.15);
    EXPECT_LT(line.widths_mm.front(), 0.5);
    EXPECT_LT(line.widths_mm.back(), 0.5);
}

TEST(ReadBark, TellsLightFromDark) {
    const BarkTile tile = tile_of(
        "<path d='M2 5 L2 25' stroke='#eee' fill='none'/>"
        "<path d='M5 5 L5 25' stroke='#111' fill='none'/>");
    ASSERT_EQ(tile.lines.size(), 2U);
    EXPECT_TRUE(tile.lines[0].light);
    EXPECT_FALSE(tile.lines[1].light);
}

TEST(ReadBark, RefusesWhatIsNoTile) {
    const std::string head = "<svg xmlns='http://www.w3.org/2000/svg'";
    EXPECT_NE(error_of(head + " viewBox='0 0 9 9'/>").find("t.svg:1:2: nothing is drawn"),
              std::string::npos);
    EXPECT_NE(error_of(head + "><path d='M0 0 L1 9' stroke='red'/></svg>").find("t.svg:1:2: "),
              std::string::npos);
    EXPECT_NE(error_of("<p/>").find("t.svg:1:2: 'p' is not an SVG drawing"), std::string::npos);
}

// All have strokes that overrun an edge, or their copies would show.
TEST(ReadBark, ReadsOurOwnTiles) {
    std::size_t tiles = 0;
    const Catalogue catalogue;
    for (const std::string name : {"furrowed", "lenticels", "peeling", "plated"}) {
        const SourceText source = catalogue.find_leaf("bark-" + name);
        const BarkImport import = read_bark(source.text, source.origin);
        EXPECT_TRUE(import.warnings.empty()) << name;
        EXPECT_GT(import.tile.lines.size(), 40U) << name;
        const bool overruns = std::ranges::any_of(import.tile.lines, [&](const BarkLine& line) {
            return std::ranges::any_of(line.points, [&](Vec2 p) {
                return p.x < 0 || p.y < 0 || p.x > import.tile.width_mm ||
                       p.y > import.tile.height_mm;
            });
        });
        EXPECT_TRUE(overruns) << name;
        for (const BarkLine& line : import.tile.lines) {
            ASSERT_GE(line.points.size(), 2U);
            EXPECT_EQ(line.points.size(), line.widths_mm.size());
            for (const double width : line.widths_mm)
                EXPECT_TRUE(width >= 0 && width < 3) << name;
        }
        ++tiles;
    }
    EXPECT_EQ(tiles, 4U);
}

}  // namespace
}  // namespace edaha
