// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "app/console.h"
#include "app/options.h"
#include "style/catalogue.h"
#include "style/style.h"

namespace edaha {

// The style that a command line asks for, with all that it changes, and the meshes that it names.
struct TreeStyle {
    Style style;
    std::string command;  // that draws it again; for an SVG, how that was drawn and what is changed
};

// TreeOptions::style is a name, a style file, an SVG or SVGZ with our metadata, or "-": standard
// input holds a style file. The palette is chosen first, then single values are set.
// Errors: InputError and IoError for the style, UsageError for the values of options.
TreeStyle read_tree_style(const TreeOptions& options, const Catalogue& catalogue, Console& console);

// The same in two steps, for those who change one style in many ways.
TreeStyle read_unchanged_style(const std::string& name, const Catalogue& catalogue,
                               Console& console);
TreeStyle change_style(TreeStyle tree, const TreeOptions& options);

// The style that a file in `folder` calls `name`: one of the catalogue, or a style file. Command,
// leaf drawings and meshes are as seen from there, wherever the program runs. Errors: InputError
// and IoError.
TreeStyle read_style_beside(const std::string& name, const std::filesystem::path& folder,
                            const Catalogue& catalogue);

// "120mm", "12cm", "5in", "400px", "340pt" in millimetres (CSS: 96 px and 72 pt an inch).
// Errors: UsageError.
double parse_length_mm(const std::string& option, const std::string& text);

}  // namespace edaha
