// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "app/gallery/gallery_pages.h"
#include "app/gallery/gallery_xml.h"
#include "base/error.h"

// Any bytes as a gallery.xml: read, or refused with problems that have a place. What is read has
// pages.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    using namespace edaha;
    const Catalogue catalogue;
    LeafShelf leaves(catalogue);
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const Gallery gallery = read_gallery({text, "fuzz.xml", {}}, catalogue, leaves);
        const std::vector<PlateFacts> facts(gallery.plates.size());
        if (gallery_pages(gallery, facts).size() != gallery.pages.size() + 2) std::abort();
    } catch (const InputError& error) {
        if (error.problems().empty()) std::abort();
        for (const Problem& problem : error.problems()) {
            if (problem.place.line < 1 || problem.message.empty()) std::abort();
        }
    }
    return 0;
}
