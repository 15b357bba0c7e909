// SPDX-License-Identifier: MIT
#include "write/eps.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/number_text.h"
#include "write/canvas.h"

namespace edaha {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr std::string_view kRecipe = "%EdahaRecipe: ";
constexpr std::size_t kMostTitleBytes = 200;  // a line of these comments has 255 at most

// Printable ASCII as a PostScript string; other characters become '?'.
std::string postscript_text(std::string_view text) {
    std::string result = "(";
    for (const char c : text.substr(0, kMostTitleBytes)) {
        if (c == '(' || c == ')' || c == '\\') {
            result += '-';
        } else {
            result += c >= ' ' && c <= '~' ? c : '?';
        }
    }
    return result + ')';
}

// The head that Adobe's "Document Structuring Conventions" 3.0 ask for. Cairo's own has the date
// and the box of the ink. Cairo hangs the page from a whole number of points.
std::string head(const Drawing& drawing) {
    const double width = drawing.width_mm * kPointsPerMm;
    const double height = drawing.height_mm * kPointsPerMm;
    const double top = std::ceil(height);
    std::string text = "%!PS-Adobe-3.0 EPSF-3.0\n";
    text += fmt::format("%%Title: {}\n", postscript_text(drawing.metadata.title));
    text += fmt::format("%%Creator: {}\n", postscript_text("edaha " + drawing.metadata.version));
    text += fmt::format("%%BoundingBox: 0 0 {:.0f} {:.0f}\n", std::ceil(width), top);
    text += "%%HiResBoundingBox: 0 " + number_text(top - height, 4) + ' ' + number_text(width, 4) +
            ' ' + number_text(top, 4) + '\n';
    if (!drawing.metadata.recipe.empty())
        text += std::string(kRecipe) + postscript_text(drawing.metadata.recipe) + '\n';
    return text + "%%Pages: 1\n%%DocumentData: Clean7Bit\n%%LanguageLevel: 2\n%%EndComments\n";
}

}  // namespace

std::string eps_bytes(const Drawing& drawing, const EpsParams& params) {
    Canvas canvas(Canvas::Kind::eps, drawing.width_mm * kPointsPerMm,
                  drawing.height_mm * kPointsPerMm);
    for (const Layer& layer : drawing.layers) {
        canvas.draw(drawing, layer, kPointsPerMm, params.paper);
    }
    std::string bytes = canvas.finish();
    constexpr std::string_view kEndOfHead = "%%EndComments\n";
    bytes.replace(0, bytes.find(kEndOfHead) + kEndOfHead.size(), head(drawing));
    return bytes;
}

std::string eps_recipe(std::string_view eps) {
    const std::size_t at = eps.substr(0, eps.find("%%EndComments")).find(kRecipe);
    if (at == std::string_view::npos) return "";
    const std::string_view text = eps.substr(at + kRecipe.size() + 1);
    return std::string(text.substr(0, text.find(')')));
}

}  // namespace edaha
