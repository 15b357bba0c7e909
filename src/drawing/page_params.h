// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// The page is as large as the drawing and its margins.
struct PageParams {
    double size_mm = 0;  // longer side of the page; 0: the tree's own size
    double margin_mm = 8;
    bool background = false;  // paint the paper
};

}  // namespace edaha
