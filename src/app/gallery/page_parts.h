// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

namespace edaha {

// The files page.html, with {{places}} for what a gallery fills in, page.css and page.js, which are
// compiled in.
struct PageParts {
    std::string_view html, css, script;
};

PageParts page_parts();

}  // namespace edaha
