// SPDX-License-Identifier: MIT
#include "app/picture_file.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "app/solid_files.h"
#include "app/version.h"
#include "base/atomic_file.h"
#include "base/fingerprint.h"
#include "base/number_text.h"
#include "style/style_xml.h"
#include "style/value.h"

namespace edaha {
namespace {

std::optional<double> parse_within(const std::string& option, const std::string& text, double least,
                                   double most) {
    if (text.empty()) return std::nullopt;
    const auto value = parse_number(text);
    if (value && *value >= least && *value <= most) return value;
    throw UsageError(fmt::format("{}: {} is not a number of {} … {}", option, in_quotes(text),
                                 shortest_text(least), shortest_text(most)));
}

}  // namespace

Format parse_format(const std::string& text) {
    const auto format = std::ranges::find(kFormats, text, name);
    if (format != kFormats.end()) return *format;
    throw UsageError(fmt::format("--format: {} is not known (expected svg, svgz, pdf, png or eps)",
                                 in_quotes(text)));
}

WriteParams write_params(const WriteOptions& options, const Style& style) {
    WriteParams params;
    params.svg.expand = options.expand;
    params.svg.swatches = options.swatches;
    // Above these, no picture fits into the limit of pixels that the writer has.
    if (const auto dpi = parse_within("--dpi", options.dpi, 1, 10000)) params.png.dpi = *dpi;
    if (const auto width = parse_within("--width", options.width, 1, 32767)) {
        params.png.width_px = static_cast<int>(*width);
    }
    params.eps.paper = style.palette.paper;
    return params;
}

std::string text_of(const WriteParams& params) {
    return fmt::format("{} {} {} {}", params.svg.expand, params.svg.swatches,
                       params.png.width_px.value_or(0), shortest_text(params.png.dpi));
}

Metadata metadata_of(const TreeStyle& tree, const WriteParams& params, LeafShelf& leaves) {
    const Style& style = tree.style;
    Metadata metadata;
    metadata.title = style.title;
    metadata.description = style.description;
    metadata.command = tree.command;
    metadata.style_xml = to_xml(style);
    metadata.version = kVersion;
    metadata.seed = style.energy.variant.seed;
    Fingerprint recipe;
    for (const std::string& text :
         {metadata.version, metadata.command, metadata.style_xml, text_of(params)})
        recipe.add(text);
    for (const OrnamentParams* ornament : {&style.leaf, &style.blossom, &style.fruit}) {
        if (!ornament->shape.empty()) recipe.add(leaves.fingerprint(ornament->shape));
    }
    if (!style.flatten.bark_tile.empty()) recipe.add(leaves.fingerprint(style.flatten.bark_tile));
    for (const std::string& bytes : solid_bytes(style.surface))
        recipe.add(bytes);
    metadata.recipe = recipe.text();
    return metadata;
}

WriteReport write_file(const Drawing& drawing, const std::string& path, Format format,
                       const WriteParams& params) {
    AtomicFile file(path);
    const WriteReport report =
        write_drawing(drawing, format, params, [&](std::string_view piece) { file.write(piece); });
    file.commit();
    return report;
}

std::vector<std::string> warnings(const Picture& picture, const SvgReport& report) {
    std::vector<std::string> texts;
    for (const Problem& warning : picture.warnings)
        texts.push_back(to_string(warning));
    if (report.split_paths > 0) {
        texts.push_back(fmt::format("{} paths had too many nodes for Illustrator and were split",
                                    report.split_paths));
    }
    if (report.oversized_paths > 0) {
        texts.push_back(
            fmt::format("{} paths have too many nodes for Illustrator", report.oversized_paths));
    }
    return texts;
}

}  // namespace edaha
