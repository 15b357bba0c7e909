// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/gallery/gallery.h"
#include "app/leaf_shelf.h"

namespace edaha {

// From a plate to its files. A tree alone has the very SVG that its command draws. Thumbnails are
// laid on the picture's own paper, so that they look the same on light and on dark pages.

struct PlateRecipes {
    std::string svg;
    std::string png;
};

// What the files of a plate record if they are still what would be drawn. Draws nothing.
PlateRecipes recipes_of(const Plate& plate, LeafShelf& leaves);

struct PlateFiles {
    std::string svg;
    std::string png;
    std::vector<std::string> warnings;  // of the leaf drawings
};

// Errors: InputError for leaf drawings, IoError for a thumbnail that is too large.
PlateFiles draw_plate(const Plate& plate, LeafShelf& leaves);

// What a picture stands on.
Colour paper_of(const Plate& plate);

}  // namespace edaha
