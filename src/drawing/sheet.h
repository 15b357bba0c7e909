// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace edaha {

// One picture of a sheet. `id` is an XML name, unique on the sheet.
struct Tile {
    Drawing drawing;
    std::string id;
    std::string caption;  // empty: none
};

struct SheetColours {
    Colour paper{0xfb, 0xf7, 0xee};
    Colour ink{0x5c, 0x54, 0x4b};  // of captions
};

struct SheetParams {
    double width_mm = 297, height_mm = 210;  // A4, landscape
    double margin_mm = 12;
    double gap_mm = 4;      // between cells
    double caption_mm = 2;  // height of a capital; 0: no captions
    int columns = 6, rows = 4;
    // Of the pictures, at most: give all pages of a book the first one's. 0: as large as fits.
    double most_scale = 0;
    SheetColours colours;
    std::string heading;              // above the cells, left
    std::size_t page = 1, pages = 1;  // above the cells, right, where there are several
};

// A contact sheet: columns x rows pictures at most, in reading order, with captions. All have one
// scale, the largest at which each fits its cell, and each row stands on one ground line. Cells are
// a millimetre wide and high at least.
//   - A picture becomes a group of the tile's id, its layers groups in it, with their paint as it
//     was; each id inside is prefixed by the tile's ("cherry-7.Wood"). Symbols that are alike
//     become one.
//   - Margins around the ink are not kept; a layer "Background" becomes the cell's card.
//   - A caption that is too wide for its cell is drawn smaller.
//   - Layers: "Paper", "Pictures", "Captions". Metadata and swatches are left to the caller.
// O(content).
Drawing sheet_page(std::span<const Tile> tiles, const SheetParams& params);

// The scale of sheet_page() for these tiles.
double sheet_scale(std::span<const Tile> tiles, const SheetParams& params);

struct StripParams {
    double tallest_mm = 50;      // from the highest top to the lowest foot of a picture
    double most_width_mm = 250;  // where it would be wider, all pictures get smaller
    double margin_mm = 2;
    double gap_mm = 6;
    double caption_mm = 2.4;
    bool ids = false;              // keep ids within pictures, and symbols' names
    Colour ink{0x7d, 0x74, 0x6a};  // reads on light and on dark pages
    std::optional<Colour> paper;
};

// The tiles in one row on a page just as large as they need, as sheet_page() draws them.
Drawing strip(std::span<const Tile> tiles, const StripParams& params);

struct PosterParams {
    double width_mm = 300;
    double margin_mm = 8;
    double gap_mm = 6;  // between rows, and at least between the pictures of one
    double caption_mm = 2;
    SheetColours colours;
    std::vector<std::size_t> rows;  // how many of the tiles, in their order, each takes
};

// Rows of pictures at one scale, the largest at which the fullest row fits the width. Each row
// stands on a line of its own, is as high as it needs, and shares the space that its pictures leave
// equally. Otherwise as sheet_page(); the height follows. `rows` add up to the number of tiles.
Drawing poster(std::span<const Tile> tiles, const PosterParams& params);

}  // namespace edaha
