// SPDX-License-Identifier: MIT
#include "readers/pictures.h"
#include "support/image_diff.h"
#include "support/run.h"

namespace edaha::test {
namespace {

class Rasters : public EveryStyle {
  protected:
    void write(const Drawing& drawing) const {
        write_whole(name(".svg"), in_format(drawing, Format::svg));
        write_whole(name(".pdf"), in_format(drawing, Format::pdf));
    }

    // How far our SVG, drawn by librsvg, is from our PDF, drawn by a program of poppler's. Both
    // should say nothing.
    double difference(int width_px, const std::string& poppler) const {
        const std::string width = std::to_string(width_px);
        read("rsvg-convert -w " + width + " -o " + name(".png") + ' ' + name(".svg"));
        // -W: it rounds up, be the page wider by the hundredth of a pixel.
        read(poppler + " -png -singlefile -scale-to-x " + width + " -scale-to-y -1 -W " + width +
             ' ' + name(".pdf") + ' ' + name("-pdf"));
        const ImageDifference difference = compare_images(name(".png"), name("-pdf.png"));
        EXPECT_EQ(difference.note, "");
        EXPECT_GT(difference.inked, 0.01) << "nothing was drawn";
        return difference.mean;
    }

  private:
    static void read(const std::string& command) {
        const RunResult result = run(command);
        EXPECT_EQ(result.exit_code, 0) << command;
        EXPECT_EQ(result.out + result.err, "") << command;
    }

    std::string name(const std::string& ending) const { return folder_ / ("tree" + ending); }

    TemporaryFolder folder_;
};

// librsvg and pdftocairo smooth edges by the same rule: what is left is rounding. A leaf that is
// missing, in another place or in another colour at every twig is far more.
TEST_P(Rasters, OfSvgAndPdfAgree) {
    // The PDF of a tree in full leaf takes seconds.
    for (const std::uint64_t seed : seeds(GetParam(), 3)) {
        write(draw_tree(GetParam(), seed).drawing);
        EXPECT_LT(difference(300, "pdftocairo"), 0.002) << "seed " << seed;
    }
}

// pdftoppm draws by a rule of its own, so edges differ; the larger the picture, the less they
// count.
TEST_P(Rasters, AgreeByAnotherRule) {
    write(draw_tree(GetParam(), 1).drawing);
    EXPECT_LT(difference(1200, "pdftoppm"), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Styles, Rasters, testing::ValuesIn(built_in_styles()), style_test_name);

}  // namespace
}  // namespace edaha::test
