// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/gallery/gallery.h"
#include "app/leaf_shelf.h"

namespace edaha {

// All the files of a gallery, beside its gallery.xml: of each plate an SVG and a thumbnail in its
// page's folder; README.md, a Markdown file a page, and index.html.

// Names are relative to the folder, in the gallery's order.
struct GalleryReport {
    std::vector<std::string> drawn;    // pictures ("kinds/oak.svg", whose thumbnail was drawn too)
    std::vector<std::string> written;  // pages
    std::vector<std::string> missing;  // of check_gallery
    std::vector<std::string> different;  // of check_gallery
    std::vector<std::string> stale;      // in page folders, and not of this gallery
    std::vector<std::string> warnings;   // of leaf drawings, each once
};

struct GalleryPlace {
    std::filesystem::path folder;
    int jobs = 0;      // pictures at a time; 0: as many as there are processors
    bool all = false;  // draw what records that it is up to date, too
};

// Draws the pictures whose files do not record that they are what would be drawn, and writes the
// pages whose text changed. What is stale is left there. Errors: IoError, before anything is drawn
// where a page's file is there that another hand wrote; else what was written by then stays, and is
// left alone the next time.
GalleryReport update_gallery(const Gallery& gallery, const GalleryPlace& place, LeafShelf& leaves);

// Draws everything in memory and compares it with the files. Errors: IoError.
GalleryReport check_gallery(const Gallery& gallery, const GalleryPlace& place, LeafShelf& leaves);

}  // namespace edaha
