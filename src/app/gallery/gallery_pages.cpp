// SPDX-License-Identifier: MIT
#include "app/gallery/gallery_pages.h"

namespace edaha {

std::vector<PageFile> gallery_pages(const Gallery& gallery, std::span<const PlateFacts> facts) {
    std::vector<PageFile> files;
    files.push_back({"README.md", markdown_contents(gallery, facts)});
    for (const GalleryPage& page : gallery.pages)
        files.push_back({page.name + ".md", markdown_page(gallery, page, facts)});
    files.push_back({"index.html", html_page(gallery, facts)});
    return files;
}

}  // namespace edaha
