// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace edaha {

// Of `edaha gallery`, as they were written.
struct GalleryOptions {
    std::string file = "gallery/gallery.xml";
    std::string jobs;
    bool check = false;
    bool all = false;
};

}  // namespace edaha
