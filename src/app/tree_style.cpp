// SPDX-License-Identifier: MIT
#include "app/tree_style.h"

#include <istream>
#include <iterator>

#include <fmt/core.h>

#include "app/shell_word.h"
#include "app/solid_files.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/number_text.h"
#include "style/style_xml.h"
#include "style/value.h"
#include "write/svg_metadata.h"

namespace edaha {
namespace {

// Redrawing reads the whole picture only to find its few lines of metadata.
constexpr std::size_t kMostSvgBytes = std::size_t{1} << 30;

bool is_picture(const std::string& name) {
    return name.ends_with(".svg") || name.ends_with(".svgz");
}

std::string changes_text(const TreeOptions& options) {
    std::string text;
    const auto add = [&](const std::string& option, const std::string& value) {
        text += ' ' + option + ' ' + shell_word(value);
    };
    for (const Setting& setting : options.settings)
        add(setting.option, setting.value);
    for (const std::string& assignment : options.assignments)
        add("--set", assignment);
    if (!options.palette.empty()) add("--palette", options.palette);
    if (!options.size.empty()) add("--size", options.size);
    if (options.background) text += " --background";
    return text;
}

std::string draw_command(const std::string& style) {
    return "edaha draw " + shell_word(style);
}

TreeStyle read_from_picture(const std::string& file, const Catalogue& catalogue) {
    const auto metadata = read_svg_metadata(read_file(file, kMostSvgBytes));
    if (!metadata || metadata->style_xml.empty()) {
        throw IoError(fmt::format("'{}' does not say which style it was drawn from", file));
    }
    const SourceText source{metadata->style_xml, "style in " + file, {}};
    return {with_solid_files(read_style(source, catalogue)), metadata->command};
}

void change(Style& style, const TreeOptions& options) {
    if (!options.palette.empty()) choose_palette(style, options.palette);
    for (const Setting& setting : options.settings) {
        if (const auto wrong = assign(style, *find_parameter(setting.key), setting.value)) {
            throw UsageError(setting.option + ": " + *wrong);
        }
    }
    set_parameters(style, options.assignments, "--set");
    if (!options.size.empty()) style.page.size_mm = parse_length_mm("--size", options.size);
    if (options.background) style.page.background = true;
}

}  // namespace

TreeStyle read_unchanged_style(const std::string& name, const Catalogue& catalogue,
                               Console& console) {
    if (is_picture(name)) return read_from_picture(name, catalogue);
    SourceText source;
    if (name == "-") {
        source = {
            std::string(std::istreambuf_iterator<char>(console.in), {}), "standard input", {}};
    } else {
        source = catalogue.find_style(name);
    }
    return {with_solid_files(read_style(source, catalogue)), draw_command(name)};
}

TreeStyle change_style(TreeStyle tree, const TreeOptions& options) {
    try {
        change(tree.style, options);
    } catch (const InputError& error) {
        std::string lines;
        for (const Problem& problem : error.problems())
            lines += (lines.empty() ? "" : "\nedaha: ") + to_string(problem);
        throw UsageError(lines);
    }
    tree.command += changes_text(options);
    return tree;
}

TreeStyle read_tree_style(const TreeOptions& options, const Catalogue& catalogue,
                          Console& console) {
    return change_style(read_unchanged_style(options.style, catalogue, console), options);
}

TreeStyle read_style_beside(const std::string& name, const std::filesystem::path& folder,
                            const Catalogue& catalogue) {
    const SourceText source = catalogue.find_style(name, folder);
    Style style = with_solid_files(read_style(source, catalogue));
    const auto from_folder = [&](std::string& file) {
        if (folder.empty() || source.folder.empty()) return;
        const std::filesystem::path path = file;
        file = path.lexically_proximate(folder).lexically_normal().generic_string();
    };
    for (OrnamentParams* ornament : {&style.leaf, &style.blossom, &style.fruit}) {
        if (std::filesystem::path(ornament->shape).has_parent_path()) from_folder(ornament->shape);
    }
    for (std::vector<SolidParams>* solids : {&style.surface.hollows, &style.surface.obstacles}) {
        for (SolidParams& solid : *solids)
            if (!solid.file.empty()) from_folder(solid.file);
    }
    return {std::move(style), draw_command(name)};
}

double parse_length_mm(const std::string& option, const std::string& text) {
    constexpr struct {
        std::string_view name;
        double mm;
    } kUnits[] = {{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"px", 25.4 / 96}, {"pt", 25.4 / 72}};
    constexpr double kMost = 10000;  // as the parameter page.size
    for (const auto& unit : kUnits) {
        if (!text.ends_with(unit.name)) continue;
        const auto value = parse_number(trim(text.substr(0, text.size() - unit.name.size())));
        if (!value) break;
        if (*value > 0 && *value * unit.mm <= kMost) return *value * unit.mm;
        throw UsageError(fmt::format("{}: {} is out of range (expected above 0, up to 10000mm)",
                                     option, in_quotes(text)));
    }
    throw UsageError(
        fmt::format("{}: {} is not a length (expected a number and mm, cm, in, px or pt)", option,
                    in_quotes(text)));
}

}  // namespace edaha
