// SPDX-License-Identifier: MIT
#include "write/png_pixels.h"

#include <gtest/gtest.h>

#include "drawing/palette.h"
#include "support/sample_drawing.h"
#include "write/png.h"

namespace edaha {
namespace {

// An empty page of 60 x 50 pixels.
std::string png_on(Colour background) {
    PngParams params;
    params.width_px = 60;
    params.background = background;
    Drawing page;
    page.width_mm = 12;
    page.height_mm = 10;
    return png_bytes(page, params);
}

TEST(PngSize, IsWhatWasAskedFor) {
    EXPECT_EQ(png_size(png_on({255, 255, 255})), (PixelSize{60, 50}));
    EXPECT_EQ(png_size("no picture, but long enough to be one"), PixelSize{});
    EXPECT_EQ(png_size(""), PixelSize{});
}

TEST(PngPixels, FilesThatRecordOtherThingsAreAlike) {
    Drawing drawing = test::sample_drawing();
    PngParams params;
    params.width_px = 60;
    const std::string first = png_bytes(drawing, params);
    drawing.metadata.recipe = "another";
    const std::string second = png_bytes(drawing, params);
    EXPECT_NE(first, second);
    EXPECT_TRUE(are_alike(first, second, 0));
}

TEST(PngPixels, DifferenceIsMeasuredInSteps) {
    const std::string paper = png_on({200, 200, 200}), near = png_on({200, 202, 200});
    EXPECT_TRUE(are_alike(paper, near, 2));
    EXPECT_FALSE(are_alike(paper, near, 1));
}

TEST(PngPixels, WhatIsNoPictureIsLikeNothing) {
    const std::string png = png_on({200, 200, 200});
    EXPECT_FALSE(are_alike(png, png.substr(0, png.size() / 2), 255));
    EXPECT_FALSE(are_alike("", "", 255));
    PngParams params;
    params.width_px = 61;
    EXPECT_FALSE(are_alike(png, png_bytes(test::sample_drawing(), params), 255));
}

}  // namespace
}  // namespace edaha
