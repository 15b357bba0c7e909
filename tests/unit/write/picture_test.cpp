// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/error.h"
#include "support/image_diff.h"
#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/eps.h"
#include "write/png.h"

namespace edaha {
namespace {

using test::quoted;

std::string identify(const std::string& bytes, const std::string& format) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "a.png", bytes);
    const auto result =
        test::run("identify -format " + quoted(format) + ' ' + quoted(folder / "a.png"));
    EXPECT_EQ(result.err, "");
    return result.out;
}

Drawing blank(double width, double height) {
    Drawing drawing;
    drawing.width_mm = width;
    drawing.height_mm = height;
    return drawing;
}

std::string error_of(const Drawing& drawing, const PngParams& params) {
    try {
        png_bytes(drawing, params);
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

TEST(Png, SizeFollowsFromWidthOrResolution) {
    EXPECT_EQ(identify(png_bytes(blank(120, 100), {.width_px = 300}), "%w %h"), "300 250");
    EXPECT_EQ(identify(png_bytes(blank(25.4, 50.8), {.dpi = 96}), "%w %h"), "96 192");
    EXPECT_EQ(identify(png_bytes(blank(300, 0.1), {.width_px = 10}), "%w %h"), "10 1");
    EXPECT_EQ(identify(png_bytes(blank(25.4, 25.4), {.dpi = 300}), "%[fx:resolution.x] %U"),
              "118.11 PixelsPerCentimeter");
}

TEST(Png, IsTransparentOrHasABackground) {
    const std::string corner = "%[pixel:p{0,0}]";
    EXPECT_EQ(identify(png_bytes(blank(10, 10), {.width_px = 4}), corner), "srgba(0,0,0,0)");
    const PngParams sky{.width_px = 4, .background = Colour{1, 2, 250}};
    EXPECT_EQ(identify(png_bytes(blank(10, 10), sky), corner), "srgb(1,2,250)");
}

TEST(Png, NamesWhatMadeItAndHasNoDate) {
    const std::string bytes = png_bytes(test::sample_drawing(), {.width_px = 16});
    EXPECT_NE(bytes.find("iTXtComment" + std::string(5, '\0') + "edaha draw sample --set"),
              std::string::npos);
    EXPECT_NE(bytes.find("iTXtTitle" + std::string(5, '\0') + "Sample <tree>"), std::string::npos);
    EXPECT_NE(bytes.find("edaha 0.1.0"), std::string::npos);
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST(Png, HugePicturesAreRefused) {
    EXPECT_EQ(error_of(blank(100, 100), {.width_px = 20000}),
              "a picture of 20000 x 20000 pixels is above the limit of 200000000 pixels");
    EXPECT_EQ(error_of(blank(1000, 1), {.width_px = 40000}),
              "a picture of 40000 x 40 pixels has a side above 32767 pixels");
    EXPECT_EQ(error_of(blank(10, 10), {.dpi = 1e300}).find("a picture of 39370"), 0u);
    EXPECT_EQ(error_of(blank(10, 10), {.width_px = 10, .most_pixels = 100}), "");
}

TEST(Eps, BoxIsThePageAndThereIsNoDate) {
    Drawing drawing = test::sample_drawing();
    drawing.layers.erase(drawing.layers.begin());  // else the background is as large as the page
    drawing.metadata.title = "A (b) \\ 枝";
    const std::string bytes = eps_bytes(drawing, {});
    EXPECT_EQ(bytes.find("%!PS-Adobe-3.0 EPSF-3.0\n"
                         "%%Title: (A -b- - ??"
                         "?)\n"
                         "%%Creator: (edaha 0.1.0)\n"
                         "%%BoundingBox: 0 0 341 284\n"
                         "%%HiResBoundingBox: 0 0 340.1575 283.4646\n"),
              0u)
        << bytes.substr(0, 300);
    EXPECT_EQ(bytes.find("Date"), std::string::npos);
    EXPECT_EQ(bytes.find("cairographics"), std::string::npos);
}

TEST(Eps, TranslucentInksAreMixedWithThePaper) {
    Drawing drawing = blank(10, 10);
    Path square;
    square.move_to({0, 0}), square.line_to({10, 0}), square.line_to({10, 10});
    square.line_to({0, 10}), square.close();
    Layer layer{"Sky", {}, {Shape{"", square, {}}}};
    layer.paint.fill = Colour{0, 100, 200};
    layer.paint.fill_opacity = 0.5f;
    drawing.layers = {layer};
    const test::TemporaryFolder folder;
    test::write_whole(folder / "a.eps", eps_bytes(drawing, {.paper = Colour{200, 200, 0}}));
    const auto result =
        test::run("gs -q -dSAFER -dBATCH -dNOPAUSE -dEPSCrop -sDEVICE=png16m -r72 -o " +
                  quoted(folder / "a.png") + ' ' + quoted(folder / "a.eps"));
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(identify(test::read_whole(folder / "a.png"), "%[pixel:p{9,9}]"), "srgb(100,150,100)");
}

// A symbol is a procedure, written once: an instance costs its map, and no more than that.
TEST(Eps, InstancesAreSmall) {
    const std::size_t few = eps_bytes(test::field_drawing(0, 100), {}).size();
    const std::size_t many = eps_bytes(test::field_drawing(0, 2100), {}).size();
    EXPECT_LT(many - few, 2000U * 70);
}

}  // namespace
}  // namespace edaha
