// SPDX-License-Identifier: MIT
#include "app/gallery/page_parts.h"

#include "style/built_in.h"

namespace edaha {

// Written by embed.cmake: one file each.
std::span<const BuiltIn> page_html();
std::span<const BuiltIn> page_css();
std::span<const BuiltIn> page_js();

PageParts page_parts() {
    return {page_html().front().text, page_css().front().text, page_js().front().text};
}

}  // namespace edaha
