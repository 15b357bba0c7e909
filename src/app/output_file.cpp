// SPDX-License-Identifier: MIT
#include "app/output_file.h"

#include <filesystem>
#include <ostream>

#include <fmt/core.h>

#include "app/picture_file.h"
#include "style/value.h"

namespace edaha {
namespace {

Format choose_format(const Options& options) {
    if (!options.format.empty()) return parse_format(options.format);
    if (options.output.empty() || options.output == "-") return Format::svg;
    if (const auto format = format_of_file(options.output)) return *format;
    throw UsageError(
        fmt::format("--output: the ending of {} is no format (expected svg, svgz, "
                    "pdf, png or eps)",
                    in_quotes(options.output)));
}

}  // namespace

Target choose_target(const Options& options, const std::string& stem) {
    const Format format = choose_format(options);
    if (!options.output.empty()) return {options.output, format};
    Target target{stem + '.' + std::string(name(format)), format};
    refuse_existing(target.file, options.force);
    return target;
}

void refuse_existing(const std::string& file, bool force) {
    std::error_code ignored;
    if (force || !std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) return;
    throw IoError(
        fmt::format("'{}' is there already (--force overwrites it, -o names another)", file));
}

WriteReport write_target(const Drawing& drawing, const Target& target, const WriteParams& params,
                         Console& console) {
    if (target.file == "-") {
        return write_drawing(drawing, target.format, params, [&](std::string_view piece) {
            console.out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
        });
    }
    return write_file(drawing, target.file, target.format, params);
}

}  // namespace edaha
