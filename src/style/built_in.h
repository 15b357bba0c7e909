// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>

namespace edaha {

// The files that are compiled in (catalogue.cmake lists them, embed.cmake writes the code).
struct BuiltIn {
    std::string_view name;  // without folder and ending
    std::string_view text;
};

std::span<const BuiltIn> built_in_styles();
std::span<const BuiltIn> built_in_leaves();

}  // namespace edaha
