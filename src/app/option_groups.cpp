// SPDX-License-Identifier: MIT
#include "app/option_groups.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "style/parameter.h"
#include "style/value.h"

namespace edaha {

CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& value,
                      const std::string& type, const std::string& help) {
    return app.add_option(names, value, help)->type_name(type)->take_last();
}

void add_setting(CLI::App& app, TreeOptions& tree, const std::string& option,
                 const std::string& key, const std::string& type) {
    const auto keep = [&tree, option, key](const std::string& value) {
        tree.settings.push_back({option, key, value});
    };
    const Parameter& parameter = *find_parameter(key);
    app.add_option_function<std::string>(option, keep,
                                         std::holds_alternative<Choice>(parameter.field)
                                             ? expected_text(parameter) + ": " + parameter.help
                                             : parameter.help)
        ->type_name(type)
        ->take_last();
}

void add_tree(CLI::App& app, TreeOptions& tree) {
    add_text(app, "STYLE", tree.style, "",
             "name of a style, a style file, an SVG that edaha drew, or - for standard input")
        ->required();
    add_setting(app, tree, "--seed", "variant.seed", "N");
    add_changes(app, tree);
}

void add_assignments(CLI::App& app, TreeOptions& tree) {
    app.add_option("--set", tree.assignments, "set any parameter; may be given again")
        ->type_name("GROUP.NAME=VALUE")
        ->allow_extra_args(false);
}

void add_page(CLI::App& app, TreeOptions& tree) {
    add_text(app, "--palette", tree.palette, "NAME", "colours: another palette of the style");
    add_text(app, "--size", tree.size, "LENGTH",
             "longer side of the page: 120mm, 12cm, 5in, 400px, 340pt");
    app.add_flag("--background", tree.background, "paint the paper");
}

void add_changes(CLI::App& app, TreeOptions& tree) {
    add_setting(app, tree, "--family", "variant.family", "N");
    add_setting(app, tree, "--vary", "variant.vary", "X");
    add_assignments(app, tree);
    add_setting(app, tree, "--look", "look.wood", "LOOK");
    add_page(app, tree);
}

void add_write(CLI::App& app, WriteOptions& write) {
    add_text(app, "--dpi", write.dpi, "N", "PNG: pixels an inch");
    add_text(app, "--width", write.width, "N", "PNG: pixels across");
    app.add_flag("--expand", write.expand, "SVG: leaves as shapes instead of clones");
    app.add_flag("--swatches", write.swatches, "SVG: the palette as swatches, for Inkscape");
}

void add_json(CLI::App& app, Options& options) {
    app.add_flag("--json", options.json, "report as JSON on standard output");
}

}  // namespace edaha
