// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/gallery/gallery.h"
#include "drawing/paint.h"

namespace edaha {

// What a page says of a plate's files.
struct PlateFacts {
    std::size_t svg_bytes = 0;
    int thumbnail_width_px = 0;
    int thumbnail_height_px = 0;
    Colour paper;
};

struct PageFile {
    std::string name;
    std::string text;
};

// Stands in every page file: what has it not is somebody else's.
inline constexpr std::string_view kPageMark = "Written by edaha gallery";

// README.md, NAME.md of each page, and index.html. `facts` are the plates', in their order.
std::vector<PageFile> gallery_pages(const Gallery& gallery, std::span<const PlateFacts> facts);

// Each of these alone.
std::string markdown_contents(const Gallery& gallery, std::span<const PlateFacts> facts);
std::string markdown_page(const Gallery& gallery, const GalleryPage& page,
                          std::span<const PlateFacts> facts);
std::string html_page(const Gallery& gallery, std::span<const PlateFacts> facts);

}  // namespace edaha
