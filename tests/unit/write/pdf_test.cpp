// SPDX-License-Identifier: MIT
#include "write/pdf.h"

#include <utility>
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

// A square of 18 points' side, on whole points.
Layer square(const std::string& label, Colour colour, int column) {
    constexpr double kSide = 6.35;
    Layer layer{label, {}, {}};
    layer.paint.fill = colour;
    const double left = column * kSide, right = left + kSide;
    Path path;
    path.move_to({left, kSide}), path.line_to({right, kSide});
    path.line_to({right, 2 * kSide}), path.line_to({left, 2 * kSide}), path.close();
    layer.children.emplace_back(Shape{"", path, {}});
    return layer;
}

Drawing page_of(std::vector<Layer> layers, double width_mm = 25.4) {
    Drawing drawing;
    drawing.width_mm = width_mm;
    drawing.height_mm = 25.4;
    drawing.layers = std::move(layers);
    return drawing;
}

std::string book_of(const std::vector<Drawing>& pages) {
    std::string bytes;
    PdfBook book([&](std::string_view piece) { bytes += piece; }, {});
    for (const Drawing& page : pages)
        book.add_page(page);
    book.finish();
    return bytes;
}

TEST(PdfBook, EachPageHasItsOwnSizeAndPicture) {
    const Drawing first = page_of({square("Wood", {120, 80, 60}, 1)});
    const Drawing second = page_of({square("Leaves", {60, 160, 60}, 3)}, 50.8);
    const test::TemporaryFolder folder;
    const std::string file = folder / "a.pdf";
    test::write_whole(file, book_of({first, second}));
    const auto sizes = test::run("pdfinfo -l 2 " + quoted(file));
    EXPECT_EQ(sizes.err, "");
    for (const char* line : {"Pages:           2\n", "Page    1 size:  72 x 72 pts\n",
                             "Page    2 size:  144 x 72 pts\n"}) {
        EXPECT_NE(sizes.out.find(line), std::string::npos) << line << sizes.out;
    }
    const auto shown =
        test::run("pdftoppm -r 72 -png " + quoted(file) + ' ' + quoted(folder / "p"));
    EXPECT_EQ(shown.out + shown.err, "");
    test::write_whole(folder / "1.png", png_bytes(first, {.dpi = 72}));
    test::write_whole(folder / "2.png", png_bytes(second, {.dpi = 72}));
    EXPECT_LT(test::compare_images(folder / "1.png", folder / "p-1.png").inked_mean, 0.01);
    EXPECT_LT(test::compare_images(folder / "2.png", folder / "p-2.png").inked_mean, 0.01);
}

TEST(PdfBook, PagesShareTheLayersTheyHaveInCommon) {
    const Layer paper = square("Paper", {250, 240, 230}, 0);
    const Layer wood = square("Wood", {120, 80, 60}, 1);
    const Layer leaves = square("Leaves", {60, 160, 60}, 2);
    const Layer ground = square("Ground", {200, 190, 160}, 3);
    const std::string bytes =
        book_of({page_of({paper, wood}), page_of({wood, leaves}), page_of({paper, ground, wood})});
    EXPECT_EQ(test::pdf_layers(bytes),
              (std::vector<std::string>{"Leaves", "Wood", "Ground", "Paper"}));
}

TEST(PdfBook, TheSamePagesAreTheSameBytes) {
    const Drawing drawing = test::sample_drawing();
    const std::string bytes = book_of({drawing, drawing, drawing});
    EXPECT_TRUE(bytes == book_of({drawing, drawing, drawing}));
    EXPECT_FALSE(bytes == book_of({drawing, drawing}));
}

// Forms or paths: what is shown is the same.
TEST(PdfBook, FormsShowWhatPathsShow) {
    const test::TemporaryFolder folder;
    const Drawing drawing = test::sample_drawing();
    test::write_whole(folder / "paths.pdf", pdf_bytes(drawing));
    test::write_whole(folder / "forms.pdf", book_of({drawing}));
    for (const char* name : {"paths", "forms"}) {
        const auto result =
            test::run("pdftocairo -r 100 -png -singlefile " +
                      quoted(folder / (std::string(name) + ".pdf")) + ' ' + quoted(folder / name));
        EXPECT_EQ(result.out + result.err, "");
    }
    const auto difference = test::compare_images(folder / "paths.png", folder / "forms.png");
    EXPECT_EQ(difference.note, "");
    EXPECT_LT(difference.inked_mean, 1e-3);
}

// A book holds each symbol once: how large it is costs its instances nothing.
TEST(PdfBook, InstancesAreSmallHoweverLargeTheSymbol) {
    Drawing few = test::field_drawing(0, 100), many = test::field_drawing(0, 2100);
    for (Drawing* drawing : {&few, &many}) {
        std::vector<Shape>& shapes = drawing->symbols[0].shapes;
        shapes.resize(500, shapes[0]);
    }
    EXPECT_LT(book_of({many}).size() - book_of({few}).size(), 2000U * 40);
    EXPECT_LT(book_of({many, many}).size(), 2 * book_of({many}).size());
}

// An instance costs its map: the packer finds the rest said before.
TEST(Pdf, InstancesAreSmall) {
    const std::size_t few = pdf_bytes(test::field_drawing(0, 100)).size();
    const std::size_t many = pdf_bytes(test::field_drawing(0, 2100)).size();
    EXPECT_LT(many - few, 2000U * 60);
    EXPECT_GT(many - few, 2000U * 8);
}

}  // namespace
}  // namespace edaha
