// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

// A layer drawn alone on a page of its own: a whole PDF file of one page.
struct PdfLayer {
    std::string label;
    std::string page_pdf;
};

struct LayeredPdf {
    double width_pt = 0;
    double height_pt = 0;
    std::vector<PdfLayer> layers;  // bottom first
    std::string title, subject, keywords, creator, recipe;
};

// Lays the pages over each other as forms in optional content groups: PDF 32000-1, 8.11. The one
// place that knows qpdf. (This header keeps to C++17: see CMakeLists.txt.)
std::string join_layers(const LayeredPdf& document);

// LayeredPdf::recipe of such a document; empty if there is none, or no PDF.
std::string pdf_recipe(std::string_view pdf);

}  // namespace edaha
