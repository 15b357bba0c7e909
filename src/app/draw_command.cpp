// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/tree_style.h"
#include "app/version.h"
#include "base/atomic_file.h"
#include "base/number_text.h"
#include "style/style_xml.h"
#include "style/value.h"
#include "write/format.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormatNames = "svg, svgz, pdf, png or eps";

struct Target {
    std::string file;  // "-": standard output
    Format format;
};

Format choose_format(const Options& options) {
    if (!options.format.empty()) {
        const auto format = std::ranges::find(kFormats, options.format, name);
        if (format != kFormats.end()) return *format;
        throw UsageError(fmt::format("--format: {} is not known (expected {})",
                                     in_quotes(options.format), kFormatNames));
    }
    if (options.output.empty() || options.output == "-") return Format::svg;
    if (const auto format = format_of_file(options.output)) return *format;
    throw UsageError(fmt::format("--output: the ending of {} is no format (expected {})",
                                 in_quotes(options.output), kFormatNames));
}

Target choose_target(const Options& options, const Style& style) {
    const Format format = choose_format(options);
    if (!options.output.empty()) return {options.output, format};
    Target target{style.name + '.' + std::string(name(format)), format};
    std::error_code ignored;
    if (!options.force && fs::exists(fs::symlink_status(target.file, ignored))) {
        throw IoError(fmt::format("'{}' is there already (--force overwrites it, -o names another)",
                                  target.file));
    }
    return target;
}

std::optional<double> parse_within(const std::string& option, const std::string& text, double least,
                                   double most) {
    if (text.empty()) return std::nullopt;
    const auto value = parse_number(text);
    if (value && *value >= least && *value <= most) return value;
    throw UsageError(fmt::format("{}: {} is not a number of {} … {}", option, in_quotes(text),
                                 shortest_text(least), shortest_text(most)));
}

WriteParams write_params(const Options& options, const Style& style) {
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

void describe(Drawing& drawing, const TreeStyle& tree) {
    Metadata& metadata = drawing.metadata;
    metadata.title = tree.style.title;
    metadata.description = tree.style.description;
    metadata.command = tree.command;
    metadata.style_xml = to_xml(tree.style);
    metadata.version = kVersion;
    metadata.seed = tree.style.energy.variant.seed;
}

WriteReport write(const Drawing& drawing, const Target& target, const WriteParams& params,
                  Console& console) {
    if (target.file == "-") {
        return write_drawing(drawing, target.format, params, [&](std::string_view piece) {
            console.out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
        });
    }
    AtomicFile file(target.file);
    const WriteReport report = write_drawing(drawing, target.format, params,
                                             [&](std::string_view piece) { file.write(piece); });
    file.commit();
    return report;
}

std::vector<std::string> warnings(const Picture& picture, const WriteReport& report) {
    std::vector<std::string> texts;
    for (const Problem& warning : picture.warnings)
        texts.push_back(to_string(warning));
    if (report.svg.split_paths > 0) {
        texts.push_back(fmt::format("{} paths had too many nodes for Illustrator and were split",
                                    report.svg.split_paths));
    }
    if (report.svg.oversized_paths > 0) {
        texts.push_back(fmt::format("{} paths have too many nodes for Illustrator",
                                    report.svg.oversized_paths));
    }
    return texts;
}

void print_report(const Picture& picture, const Target& target, const WriteReport& report,
                  Console& console) {
    nlohmann::ordered_json json;
    json["file"] = target.file;
    json["format"] = name(target.format);
    json["bytes"] = report.bytes;
    json["seed"] = picture.drawing.metadata.seed;
    json["command"] = picture.drawing.metadata.command;
    json["width_mm"] = picture.drawing.width_mm;
    json["height_mm"] = picture.drawing.height_mm;
    json["branches"] = picture.counts.branches;
    json["limbs"] = picture.counts.limbs;
    json["leaves"] = picture.counts.ornaments;
    json["warnings"] = warnings(picture, report);
    console.out << json.dump(2) << '\n';
}

}  // namespace

int draw(const Options& options, Console& console) {
    if (options.json && options.output == "-") {
        throw UsageError("--json and the picture can't both go to standard output");
    }
    const Catalogue catalogue(console.user_folder);
    const TreeStyle tree = read_tree_style(options.tree, catalogue, console);
    const Target target = choose_target(options, tree.style);
    const WriteParams params = write_params(options, tree.style);
    Picture picture = draw_picture(tree.style, leaf_loader(catalogue));
    describe(picture.drawing, tree);
    const WriteReport report = write(picture.drawing, target, params, console);
    for (const std::string& warning : warnings(picture, report))
        console.err << "edaha: warning: " << warning << '\n';
    if (options.output.empty()) console.err << "edaha: wrote " << target.file << '\n';
    if (options.json) print_report(picture, target, report, console);
    return 0;
}

}  // namespace edaha
