// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/picture_file.h"
#include "style/value.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

struct Target {
    std::string file;  // "-": standard output
    Format format;
};

Format choose_format(const Options& options) {
    if (!options.format.empty()) return parse_format(options.format);
    if (options.output.empty() || options.output == "-") return Format::svg;
    if (const auto format = format_of_file(options.output)) return *format;
    throw UsageError(
        fmt::format("--output: the ending of {} is no format (expected svg, svgz, "
                    "pdf, png or eps)",
                    in_quotes(options.output)));
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

WriteReport write(const Drawing& drawing, const Target& target, const WriteParams& params,
                  Console& console) {
    if (target.file == "-") {
        return write_drawing(drawing, target.format, params, [&](std::string_view piece) {
            console.out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
        });
    }
    return write_file(drawing, target.file, target.format, params);
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
    json["warnings"] = warnings(picture, report.svg);
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
    const WriteParams params = write_params(options.write, tree.style);
    LeafShelf leaves(catalogue);
    Picture picture = draw_picture(tree.style, leaves.loader());
    picture.drawing.metadata = metadata_of(tree, params, leaves);
    const WriteReport report = write(picture.drawing, target, params, console);
    for (const std::string& warning : warnings(picture, report.svg))
        console.err << "edaha: warning: " << warning << '\n';
    if (options.output.empty()) console.err << "edaha: wrote " << target.file << '\n';
    if (options.json) print_report(picture, target, report, console);
    return 0;
}

}  // namespace edaha
