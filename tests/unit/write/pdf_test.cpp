// SPDX-License-Identifier: MIT
#include "write/pdf.h"

#include <vector>

#include <gtest/gtest.h>

#include "support/image_diff.h"
#include "support/pdf_layers.h"
#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/png.h"

namespace edaha {
namespace {

using test::quoted;

TEST(Pdf, SaysWhatItIs) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "a.pdf", pdf_bytes(test::sample_drawing()));
    const auto result = test::run("TZ=UTC pdfinfo -isodates " + quoted(folder / "a.pdf"));
    EXPECT_EQ(result.err, "");
    for (const char* line :
         {"Title:           Sample <tree> & \"co\"\n", "Subject:         One of everything\n",
          "Keywords:        edaha draw sample --set 'title=<枝>'\n",
          "Creator:         edaha 0.1.0\n", "CreationDate:    2000-01-01T00:00:00Z\n",
          "Pages:           1\n", "Page size:       340.157 x 283.464 pts\n",
          "PDF version:     1.5\n"}) {
        EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
    }
}

TEST(Pdf, IsVectorsOnly) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "a.pdf", pdf_bytes(test::sample_drawing()));
    const auto images = test::run("pdfimages -list " + quoted(folder / "a.pdf") + " | tail -n +3");
    EXPECT_EQ(images.out + images.err, "");
}

TEST(Pdf, LayersAreListedByName) {
    Drawing drawing = test::sample_drawing();
    drawing.layers[0].label = "Hintergr\xc3\xbcnde";
    EXPECT_EQ(test::pdf_layers(pdf_bytes(drawing)),
              (std::vector<std::string>{"Leaves", "Wood & bark", "Hintergr\xc3\xbcnde"}));
}

// An independent reader takes the layers for what they are: each of them, switched off, is not
// drawn, and all the others still are.
TEST(Pdf, LayersCanBeSwitchedOff) {
    const test::TemporaryFolder folder;
    const Drawing drawing = test::sample_drawing();
    const std::string bytes = pdf_bytes(drawing);
    test::write_whole(folder / "all.png", png_bytes(drawing, {.dpi = 72}));
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
        const std::size_t from_top = drawing.layers.size() - 1 - i;
        test::write_whole(folder / "off.pdf", test::with_layer_off(bytes, from_top));
        const auto result = test::run("pdftoppm -r 72 -png -singlefile " +
                                      quoted(folder / "off.pdf") + ' ' + quoted(folder / "off"));
        EXPECT_EQ(result.out + result.err, "");
        Drawing rest = drawing;
        rest.layers.erase(rest.layers.begin() + static_cast<std::ptrdiff_t>(i));
        test::write_whole(folder / "rest.png", png_bytes(rest, {.dpi = 72}));
        EXPECT_LT(test::compare_images(folder / "rest.png", folder / "off.png").inked_mean, 0.015)
            << drawing.layers[i].label;
        EXPECT_GT(test::compare_images(folder / "all.png", folder / "off.png").inked_mean, 0.015)
            << drawing.layers[i].label;
    }
}

TEST(Pdf, ADrawingWithoutLayersIsAnEmptyPage) {
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = 25.4;
    const test::TemporaryFolder folder;
    test::write_whole(folder / "a.pdf", pdf_bytes(drawing));
    const auto result = test::run("pdfinfo " + quoted(folder / "a.pdf"));
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("Page size:       72 x 72 pts"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace edaha
