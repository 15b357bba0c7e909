// SPDX-License-Identifier: MIT
#include "app/batch/sheet_book.h"

#include <filesystem>
#include <regex>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/run.h"
#include "support/sample_drawing.h"

namespace edaha {
namespace {

using test::read_whole;
using test::TemporaryFolder;

SheetBookParams params_of(const TemporaryFolder& folder, std::size_t tiles) {
    SheetBookParams params;
    params.folder = folder.path();
    params.tiles = tiles;
    params.heading = "trees";
    params.metadata.title = "trees";
    params.metadata.version = "0.1.0";
    params.metadata.recipe = "0123456789abcdef";
    return params;
}

SheetTile tile_of(std::size_t index) {
    SheetTile tile{{test::sample_drawing(), "tree-" + std::to_string(index), ""}, {}, {}};
    tile.tile.caption = "tree " + std::to_string(index);
    std::erase_if(tile.tile.drawing.layers,
                  [](const Layer& layer) { return layer.label == kBackgroundLabel; });
    tile.paper = {0x20, 0x30, 0x40};
    tile.ink = {0xf0, 0xf1, 0xf2};
    return tile;
}

std::ptrdiff_t count(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {});
}

void write_book(const SheetBookParams& params) {
    SheetBook book(params);
    for (std::size_t i = 0; i < params.tiles; ++i)
        book.add(tile_of(i));
    book.finish();
}

TEST(SheetBook, WritesAPageForEveryTwentyFour) {
    for (const auto& [tiles, pages] :
         std::vector<std::pair<std::size_t, std::size_t>>{{1, 1}, {24, 1}, {25, 2}, {49, 3}}) {
        const TemporaryFolder folder;
        write_book(params_of(folder, tiles));
        const SheetBook book(params_of(folder, tiles));
        const std::vector<std::string> files = book.files();
        ASSERT_EQ(files.size(), pages + 1);
        EXPECT_EQ(files.front(), folder / "sheet-01.svg");
        EXPECT_EQ(files.back(), folder / "sheet.pdf");
        std::ptrdiff_t shown = 0;
        for (std::size_t page = 0; page < pages; ++page)
            shown += count(read_whole(files[page]), "id=\"tree-[0-9]+\"");
        EXPECT_EQ(shown, static_cast<std::ptrdiff_t>(tiles));
        const auto info = test::run("pdfinfo " + test::quoted(files.back()) + " | grep ^Pages:");
        EXPECT_TRUE(info.out.ends_with(" " + std::to_string(pages) + "\n")) << info.out;
    }
}

TEST(SheetBook, KnowsItsOwnFiles) {
    const TemporaryFolder folder;
    const SheetBookParams params = params_of(folder, 30);
    EXPECT_FALSE(SheetBook(params).is_right(false));
    write_book(params);
    EXPECT_TRUE(SheetBook(params).is_right(false));
    SheetBookParams other = params;
    other.metadata.recipe = "fedcba9876543210";
    EXPECT_FALSE(SheetBook(other).is_right(false));
    std::filesystem::rename(folder / "sheet-02.svg", folder / "sheet-01.svg");
    EXPECT_FALSE(SheetBook(params).is_right(false));
    test::write_whole(folder / "sheet-01.svg", "<svg/>");
    EXPECT_THROW(SheetBook(params).is_right(false), IoError);
    EXPECT_FALSE(SheetBook(params).is_right(true));
}

TEST(SheetBook, StandsOnTheTreesPaperOrOnCards) {
    const TemporaryFolder folder;
    SheetBookParams params = params_of(folder, 2);
    write_book(params);
    const std::string plain = read_whole(folder / "sheet-01.svg");
    params.cards = true;
    write_book(params);
    const std::string cards = read_whole(folder / "sheet-01.svg");
    EXPECT_EQ(count(plain, "\"#203040\""), 1);  // the page
    EXPECT_EQ(count(plain, "\"#f0f1f2\""), 1);  // the captions
    EXPECT_EQ(count(cards, "\"#203040\""), 2);  // one a tree
    EXPECT_EQ(count(cards, "\"#f0f1f2\""), 0);
}

TEST(SheetBook, WithoutTheLastPageThereIsNoPdf) {
    const TemporaryFolder folder;
    {
        SheetBook book(params_of(folder, 30));
        for (std::size_t i = 0; i < 26; ++i)
            book.add(tile_of(i));
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "sheet-01.svg"));
    EXPECT_FALSE(std::filesystem::exists(folder / "sheet.pdf"));
}

}  // namespace
}  // namespace edaha
