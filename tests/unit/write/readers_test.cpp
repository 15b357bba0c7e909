// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/image_diff.h"
#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/format.h"

namespace edaha {
namespace {

using test::quoted;

// All formats show the same picture: what independent programs make of our files is compared with
// our own PNG.
class Readers : public testing::Test {
  protected:
    static constexpr int kWidth = 600;  // 120 mm at 127 dpi; 100 mm are whole pixels too

    std::string write(Format format, const Drawing& drawing, SvgParams svg = {}) {
        const std::string path = folder_ / ("drawing." + std::string(name(format)));
        std::string bytes;
        WriteParams params;
        params.svg = svg;
        params.png.width_px = kWidth;
        write_drawing(drawing, format, params, [&](std::string_view part) { bytes += part; });
        test::write_whole(path, bytes);
        return path;
    }

    // Runs a reader, which makes read.png and should say nothing, and compares.
    void expect_alike(const std::string& command, const Drawing& drawing, double most) {
        const auto result = test::run(command);
        EXPECT_EQ(result.exit_code, 0) << command;
        EXPECT_EQ(result.out + result.err, "") << command;
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        const std::string picture = testing::TempDir() + "edaha-readers-" + test->name() + ".png";
        EXPECT_EQ(
            test::image_complaint(write(Format::png, drawing), folder_ / "read.png", most, picture),
            "");
    }

    std::string read_png() const { return quoted(folder_ / "read.png"); }

    std::string rsvg(const std::string& file) const {
        return "rsvg-convert -w " + std::to_string(kWidth) + " -o " + read_png() + ' ' +
               quoted(file);
    }

    test::TemporaryFolder folder_;
    const Drawing drawing_ = test::sample_drawing();
};

// Edges are drawn by different rules in different programs; inside them all must be the same.
constexpr double kSameRenderer = 0.0005;  // librsvg draws with Cairo as we do
constexpr double kOtherRenderer = 0.003;

TEST_F(Readers, LibrsvgShowsOurSvg) {
    expect_alike(rsvg(write(Format::svg, drawing_)), drawing_, kSameRenderer);
}

TEST_F(Readers, LibrsvgShowsOurPackedSvg) {
    expect_alike(rsvg(write(Format::svgz, drawing_, {.swatches = true, .compact = true})), drawing_,
                 kSameRenderer);
}

TEST_F(Readers, LibrsvgShowsExpandedInstances) {
    Drawing plain = drawing_;  // but for the squeezed one, whose stroke becomes its mean width
    std::erase_if(plain.layers[2].children, [](const Element& element) {
        const auto* use = std::get_if<Use>(&element);
        return use != nullptr && use->page_from_symbol[0].x == -1.6;
    });
    expect_alike(rsvg(write(Format::svg, plain, {.expand = true})), plain, kSameRenderer);
}

TEST_F(Readers, PopplerShowsOurPdf) {
    const std::string stem = folder_ / "read";
    expect_alike("pdftoppm -r 127 -png -singlefile " + quoted(write(Format::pdf, drawing_)) + ' ' +
                     quoted(stem),
                 drawing_, kOtherRenderer);
}

TEST_F(Readers, GhostscriptShowsOurPdf) {
    expect_alike(
        "gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=png16m -r127 -dGraphicsAlphaBits=4 "
        "-o " +
            read_png() + ' ' + quoted(write(Format::pdf, drawing_)),
        drawing_, kOtherRenderer);
}

TEST_F(Readers, GhostscriptShowsOurEps) {
    Drawing opaque = drawing_;  // PostScript knows nothing else
    opaque.layers[0].children.erase(opaque.layers[0].children.begin() + 1);
    opaque.layers[2].paint.fill_opacity = 1;
    for (Symbol& symbol : opaque.symbols)
        symbol.shapes[1].paint.fill_opacity = 1;
    auto& group = std::get<Group>(opaque.layers[1].children[1]);
    std::get<Shape>(group.children[2]).paint.stroke_opacity = 1;
    expect_alike(
        "gs -q -dSAFER -dBATCH -dNOPAUSE -dEPSCrop -sDEVICE=png16m -r127 "
        "-dGraphicsAlphaBits=4 -o " +
            read_png() + ' ' + quoted(write(Format::eps, opaque)),
        opaque, kOtherRenderer);
}

TEST_F(Readers, InkscapeShowsOurSvg) {
    // Without a desktop Inkscape warns of its list of recent files, whatever it opens.
    expect_alike("inkscape -w 600 -o " + read_png() + ' ' + quoted(write(Format::svg, drawing_)) +
                     " 2>&1 | grep -v -e GtkRecentManager -e '^$' || true",
                 drawing_, kOtherRenderer);
}

TEST_F(Readers, InkscapeSeesOurLayersAndSize) {
    const std::string file = quoted(write(Format::svg, drawing_));
    const auto size = test::run("inkscape --query-id=sky --query-width " + file);
    EXPECT_NEAR(std::stod(size.out), 120 * 96 / 25.4, 0.01) << size.err;
}

}  // namespace
}  // namespace edaha
