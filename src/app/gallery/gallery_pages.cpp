// SPDX-License-Identifier: MIT
#include "app/gallery/gallery_pages.h"

#include <fmt/core.h>

namespace edaha {

std::vector<PageFile> gallery_pages(const Gallery& gallery, std::span<const PlateFacts> facts) {
    const std::string head = fmt::format("<!-- {} -->\n", kPageMark);
    std::vector<PageFile> files;
    files.push_back({"README.md", head + markdown_contents(gallery, facts)});
    for (const GalleryPage& page : gallery.pages)
        files.push_back({page.name + ".md", head + markdown_page(gallery, page, facts)});
    files.push_back({"index.html", html_page(gallery, facts)});
    return files;
}

}  // namespace edaha
