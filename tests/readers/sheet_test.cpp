// SPDX-License-Identifier: MIT
#include "drawing/sheet.h"

#include "drawing/check.h"
#include "readers/pictures.h"
#include "support/image_diff.h"
#include "support/run.h"
#include "write/pdf.h"

namespace edaha::test {
namespace {

// Every kind of tree on one page: what the styles share by name or id, and all their paints, meet.
Drawing sheet_of_all() {
    std::vector<Tile> tiles;
    for (const std::string& style : built_in_styles()) {
        // Not the papers' figures, nor trees of thousands of sprigs, which poppler takes minutes
        // for.
        if (style.find('/') != std::string::npos || grows_surface(style)) continue;
        tiles.push_back({draw_tree(style, 1).drawing, style, style});
    }
    SheetParams params;
    params.heading = "All kinds";
    return sheet_page(tiles, params);
}

TEST(Sheets, OfAllKindsReadTheSameAsSvgAndPdf) {
    const Drawing sheet = sheet_of_all();
    EXPECT_EQ(check(sheet), std::vector<std::string>{});
    const TemporaryFolder folder;
    write_whole(folder / "sheet.svg", in_format(sheet, Format::svg));
    std::string bytes;
    PdfBook book([&](std::string_view piece) { bytes += piece; }, sheet.metadata);
    book.add_page(sheet);
    book.finish();
    write_whole(folder / "sheet.pdf", bytes);
    // Five pixels a millimetre: poppler draws no line thinner than one, and captions have many.
    const RunResult svg =
        run("rsvg-convert -w 1500 -o " + folder / "svg.png" + ' ' + folder / "sheet.svg");
    const RunResult pdf = run("pdftocairo -png -singlefile -scale-to-x 1500 -scale-to-y -1 " +
                              folder / "sheet.pdf" + ' ' + folder / "pdf");
    EXPECT_EQ(svg.out + svg.err + pdf.out + pdf.err, "");
    const ImageDifference difference = compare_images(folder / "svg.png", folder / "pdf.png");
    EXPECT_EQ(difference.note, "");
    EXPECT_LT(difference.mean, 0.002);
}

}  // namespace
}  // namespace edaha::test
