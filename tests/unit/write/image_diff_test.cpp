// SPDX-License-Identifier: MIT
#include "support/image_diff.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/png.h"

namespace edaha {
namespace {

// The comparator of all picture tests must be able to fail.
class ImageDiff : public testing::Test {
  protected:
    std::string png(const std::string& file, const Drawing& drawing, int width = 300) {
        PngParams params;
        params.width_px = width;
        test::write_whole(folder_ / file, png_bytes(drawing, params));
        return folder_ / file;
    }
    std::string complaint(const Drawing& changed, double most = 0.01) {
        return test::image_complaint(png("a.png", test::sample_drawing()), png("b.png", changed),
                                     most, folder_ / "diff.png");
    }
    test::TemporaryFolder folder_;
};

TEST_F(ImageDiff, TheSameIsAlike) {
    EXPECT_EQ(complaint(test::sample_drawing(), 0), "");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "diff.png"));
}

TEST_F(ImageDiff, AMissingLayerIsSeenAndShown) {
    Drawing changed = test::sample_drawing();
    changed.layers.pop_back();
    EXPECT_NE(complaint(changed), "");
    const test::RunResult size =
        test::run("identify -format %wx%h " + test::quoted(folder_ / "diff.png"));
    EXPECT_EQ(size.out, "900x250");  // expected | difference | actual
}

TEST_F(ImageDiff, AShiftByAMillimetreIsSeen) {
    Drawing changed = test::sample_drawing();
    for (Element& element : changed.layers[2].children) {
        if (auto* use = std::get_if<Use>(&element)) use->page_from_symbol[2].x += 1;
    }
    EXPECT_NE(complaint(changed), "");
}

TEST_F(ImageDiff, OtherSizesAreNeverAlike) {
    const std::string a = png("a.png", test::sample_drawing(), 300);
    const std::string b = png("b.png", test::sample_drawing(), 301);
    EXPECT_EQ(test::compare_images(a, b).note, "300 x 250 against 301 x 251");
    EXPECT_NE(test::image_complaint(a, b, 0.5, folder_ / "diff.png"), "");
}

TEST_F(ImageDiff, MeasuresWhatItSays) {
    Drawing grey = test::sample_drawing();
    grey.layers.clear();
    PngParams params;
    params.width_px = 10;
    params.background = Colour{204, 204, 204};  // a fifth from white
    test::write_whole(folder_ / "grey.png", png_bytes(grey, params));
    const auto difference = test::compare_images(png("white.png", grey, 10), folder_ / "grey.png");
    EXPECT_NEAR(difference.mean, 0.2, 1e-9);
    EXPECT_NEAR(difference.inked_mean, 0.2, 1e-9);
    EXPECT_NEAR(difference.worst, 0.2, 1e-9);
}

}  // namespace
}  // namespace edaha
