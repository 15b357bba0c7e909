// SPDX-License-Identifier: MIT
#include "write/format.h"

#include <algorithm>

#include "base/error.h"
#include "write/pdf.h"
#include "write/pdf_recipe.h"
#include "write/svg_metadata.h"

namespace edaha {
namespace {

bool same_letters(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

WriteReport send(const std::string& bytes, const Sink& sink) {
    sink(bytes);
    return {bytes.size(), {}};
}

}  // namespace

std::string_view name(Format format) {
    switch (format) {
        case Format::svg:
            return "svg";
        case Format::svgz:
            return "svgz";
        case Format::pdf:
            return "pdf";
        case Format::png:
            return "png";
        case Format::eps:
            return "eps";
    }
    return "";
}

std::optional<Format> format_of_file(std::string_view file_name) {
    file_name = file_name.substr(file_name.rfind('/') + 1);
    const std::size_t point = file_name.rfind('.');
    if (point == std::string_view::npos) return std::nullopt;
    const std::string_view ending = file_name.substr(point + 1);
    const auto* const found = std::find_if(kFormats.begin(), kFormats.end(), [&](Format format) {
        return same_letters(ending, name(format));
    });
    if (found == kFormats.end()) return std::nullopt;
    return *found;
}

std::string recorded_recipe(std::string_view bytes, Format format) {
    if (format == Format::pdf) return pdf_recipe(bytes);
    if (format == Format::png) return png_recipe(bytes);
    if (format == Format::eps) return eps_recipe(bytes);
    try {
        const auto metadata = read_svg_metadata(bytes);
        return metadata ? metadata->recipe : "";
    } catch (const IoError&) {
        return "";  // damaged while packed
    }
}

WriteReport write_drawing(const Drawing& drawing, Format format, const WriteParams& params,
                          const Sink& sink) {
    if (format == Format::pdf) return send(pdf_bytes(drawing), sink);
    if (format == Format::png) return send(png_bytes(drawing, params.png), sink);
    if (format == Format::eps) return send(eps_bytes(drawing, params.eps), sink);
    const SvgReport report = format == Format::svg ? write_svg(drawing, params.svg, sink)
                                                   : write_svgz(drawing, params.svg, sink);
    return {report.bytes, report};
}

}  // namespace edaha
