// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace edaha {

// Where the document's information holds Metadata::recipe: a key of our own (ISO 32000-1, 14.3.3).
inline constexpr const char* kPdfRecipeKey = "/EdahaRecipe";

// The recipe of a PDF, even if another program has saved it anew; empty if there is none, or if
// this is no PDF. The one place that knows qpdf. (This header keeps to C++17: see CMakeLists.txt.)
std::string pdf_recipe(std::string_view pdf);

}  // namespace edaha
