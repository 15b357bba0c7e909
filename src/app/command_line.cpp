// SPDX-License-Identifier: MIT
#include "app/command_line.h"

#include <algorithm>
#include <iterator>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "app/batch/batch_options.h"
#include "app/option_groups.h"
#include "app/version.h"
#include "base/nearest_name.h"

namespace edaha {
namespace {

void add_output(CLI::App& app, Options& options, const std::string& type,
                const std::string& formats) {
    add_text(app, "-o,--output", options.output, "FILE",
             "where to; its ending is the format; - is standard output");
    add_text(app, "--format", options.format, type, formats);
    app.add_flag("--force", options.force, "overwrite a file that -o does not name");
}

void add_draw(CLI::App& app, Options& options) {
    CLI::App& draw = *app.add_subcommand("draw", "draw one picture");
    add_tree(draw, options.tree);
    add_output(draw, options, "FORMAT", "svg, svgz, pdf, png or eps");
    add_write(draw, options.write);
    add_text(draw, "--frames", options.frames, "N",
             "surface growth: so many pictures of it, FILE-001 and on, all on one page");
    draw.add_flag("--stats", options.stats, "tell what each step made, and its time");
    add_json(draw, options);
    draw.footer(
        "Examples:\n"
        "  edaha draw cherry\n"
        "  edaha draw oak --seed 7 --set growth.energy=800 -o oak.pdf\n"
        "  edaha draw oak.svg --palette dark -o dark.svg\n"
        "  edaha draw old-oak --frames 24 -o grow.svg");
}

void add_gallery(CLI::App& app, Options& options) {
    CLI::App& gallery = *app.add_subcommand(
        "gallery", "draw the pictures that gallery.xml names, and write their pages");
    add_text(gallery, "FILE", options.gallery.file, "",
             "what the gallery holds; gallery/gallery.xml if left out");
    gallery.add_flag("--check", options.gallery.check,
                     "write nothing; name what is not as it would be drawn");
    gallery.add_flag("--all", options.gallery.all, "draw what has not changed, too")
        ->excludes("--check");
    add_text(gallery, "--jobs", options.gallery.jobs, "N", "pictures at a time; all processors");
    add_json(gallery, options);
    gallery.footer(
        "Examples:\n"
        "  edaha gallery\n"
        "  edaha gallery --check docs/gallery.xml\n"
        "A gallery.xml:\n"
        "  <gallery title=\"My trees\">\n"
        "    <page name=\"oaks\" title=\"Oaks\">\n"
        "      <text>Grown for *my* book.</text>\n"
        "      <picture name=\"old\" style=\"oak\" seed=\"7\" caption=\"An old oak\">\n"
        "        <set growth.energy=\"800\"/>\n"
        "      </picture>\n"
        "      <sweep name=\"leaning\" style=\"oak\" parameter=\"growth.lean\" values=\"0 | 10 | "
        "20\"/>\n"
        "    </page>\n"
        "  </gallery>");
}

void add_flatten(CLI::App& app, Options& options) {
    CLI::App& flatten =
        *app.add_subcommand("flatten", "draw a mesh (OBJ, PLY) as flat areas and lines");
    TreeOptions& tree = options.tree;
    add_text(flatten, "MODEL", options.flatten.model, "", "a file .obj or .ply")->required();
    add_setting(flatten, tree, "--azimuth", "flatten.azimuth", "DEGREES");
    add_setting(flatten, tree, "--elevation", "flatten.elevation", "DEGREES");
    add_setting(flatten, tree, "--projection", "flatten.projection", "PROJECTION");
    add_setting(flatten, tree, "--fov", "flatten.field-of-view", "DEGREES");
    add_text(flatten, "--up", options.flatten.up, "AXIS", "which axis of the mesh is up: y or z");
    add_setting(flatten, tree, "--look", "flatten.look", "FLATLOOK");
    add_text(flatten, "--style", tree.style, "STYLE",
             "colours, page and parameters of flatten from a style");
    add_assignments(flatten, tree);
    add_page(flatten, tree);
    add_output(flatten, options, "FORMAT", "svg, svgz, pdf, png or eps");
    add_write(flatten, options.write);
    flatten.add_flag("--stats", options.stats, "tell what each step made, and its time");
    add_json(flatten, options);
    flatten.footer(
        "Examples:\n"
        "  edaha flatten bunny.obj\n"
        "  edaha flatten tree.ply --azimuth 30 --elevation 15 --look lines -o tree.pdf\n"
        "  edaha flatten part.obj --up z --set flatten.bands=4 --set palette.wood=#c05030");
}

void add_mesh(CLI::App& app, Options& options) {
    CLI::App& mesh = *app.add_subcommand(
        "mesh", "write the mesh of a tree of prisms, prop roots or surface growth");
    add_tree(mesh, options.tree);
    add_output(mesh, options, "MESHFORMAT", "obj (with its materials in a file .mtl) or ply");
    add_json(mesh, options);
    mesh.footer(
        "Examples:\n"
        "  edaha mesh young-mangrove -o roots.obj\n"
        "  edaha mesh young-mangrove --seed 7 -o roots.ply && edaha flatten roots.ply");
}

void add_measure(CLI::App& app, Options& options) {
    CLI::App& measure = *app.add_subcommand("measure", "measure the tree that would be drawn");
    add_tree(measure, options.tree);
    add_json(measure, options);
    measure.footer("Example:\n  edaha measure oak --seed 7 --json");
}

void add_lists(CLI::App& app, Options& options) {
    for (const std::string name : {"styles", "leaves"}) {
        CLI::App& list = *app.add_subcommand(name, "list the " + name + " that there are");
        list.add_flag("--names", options.names, "names only, one a line");
        add_json(list, options);
        list.footer("Example:\n  edaha " + name + " --names");
    }
}

void add_check(CLI::App& app, Options& options) {
    CLI::App& check = *app.add_subcommand("check", "say what is wrong with styles and leaves");
    check.add_option("FILE", options.files, "style files (.xml) and leaf drawings (.svg)")
        ->type_name("")
        ->required();
    check.footer("Example:\n  edaha check my-oak.xml my-leaf.svg");
}

void add_explain(CLI::App& app, Options& options) {
    CLI::App& explain = *app.add_subcommand("explain", "explain what a style can set");
    add_text(explain, "PARAMETER", options.topic, "",
             "a parameter or a group of them; all of them if left out");
    add_json(explain, options);
    explain.add_flag("--markdown", options.markdown, "all of it as a page in Markdown");
    explain.add_flag("--schema", options.schema, "an XML Schema of style files, for editors");
    explain.footer("Examples:\n  edaha explain growth.energy\n  edaha explain --schema >style.xsd");
}

void add_manuals(CLI::App& app, Options& options) {
    CLI::App& completion =
        *app.add_subcommand("completion", "print a script that completes edaha in a shell");
    add_text(completion, "SHELL", options.shell, "", "bash, zsh or fish")->required();
    completion.footer("Example:\n  eval \"$(edaha completion bash)\"");
    CLI::App& man = *app.add_subcommand("man", "print the manual page");
    man.footer("Example:\n  edaha man | man -l -");
}

std::string how_to_go_on(const CLI::App& app) {
    return fmt::format("\nTry '{}{} --help'.", app.get_parent() != nullptr ? "edaha " : "",
                       app.get_name());
}

// The command that the arguments chose, or the whole program.
const CLI::App& chosen(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
}

std::string explain_extras(const CLI::App& app) {
    const CLI::App& command = chosen(app);
    const std::vector<std::string> extras = app.remaining(true);
    const auto option = std::ranges::find_if(extras, [](const std::string& extra) {
        return extra.size() > 1 && extra.starts_with('-');
    });
    if (option == extras.end()) {
        return fmt::format("{}: '{}' is one argument too many", command.get_name(), extras.front());
    }
    const std::string name = option->substr(0, option->find('='));
    std::vector<std::string> known;
    for (const CLI::Option* each : command.get_options()) {
        for (const std::string& long_name : each->get_lnames())
            known.push_back("--" + long_name);
    }
    const auto longer = std::ranges::find_if(
        known, [&](const std::string& each) { return each.starts_with(name + '-'); });
    return fmt::format(
        "{}: there is no option '{}'{}", command.get_name(), name,
        longer != known.end() ? " (did you mean '" + *longer + "'?)" : did_you_mean(name, known));
}

std::string explain_error(const CLI::App& app, const CLI::ParseError& error) {
    const std::string message = error.what();
    // An unknown option may be the reason why something else is missing.
    if (!app.remaining(true).empty()) return explain_extras(app);
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        if (app.get_subcommands().empty()) return "a command is missing";
        const std::string name = message.substr(0, message.find(' '));
        return fmt::format("{}: {} is missing", chosen(app).get_name(), name);
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return fmt::format("{}: {} needs a value", chosen(app).get_name(),
                           message.substr(0, message.find(':')));
    }
    return fmt::format("{}: {}", chosen(app).get_name(), message);
}

void refuse_unknown_command(const CLI::App& app, std::span<const std::string> arguments) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({}))
        names.push_back(command->get_name());
    if (arguments.empty()) throw UsageError("a command is missing" + how_to_go_on(app));
    const std::string& first = arguments.front();
    if (first.starts_with('-') || std::ranges::count(names, first) > 0) return;
    throw UsageError(fmt::format("there is no command '{}'{}", first, did_you_mean(first, names)) +
                     how_to_go_on(app));
}

}  // namespace

std::shared_ptr<CLI::App> define_command_line(Options& options) {
    auto app = std::make_shared<CLI::App>(
        "Grows trees and draws them as flat, editable vector illustrations.", "edaha");
    app->get_formatter()->column_width(34);
    app->get_formatter()->label("REQUIRED", "");
    app->set_version_flag("--version", std::string("edaha ") + kVersion, "print the version");
    app->set_help_flag("-h,--help", "print help");
    app->require_subcommand(1);
    add_draw(*app, options);
    add_batch(*app, options);
    add_gallery(*app, options);
    add_flatten(*app, options);
    add_mesh(*app, options);
    add_measure(*app, options);
    add_lists(*app, options);
    add_check(*app, options);
    add_explain(*app, options);
    add_manuals(*app, options);
    app->footer(
        "Examples:\n"
        "  edaha draw cherry -o cherry.svg\n"
        "  edaha styles\n"
        "  edaha explain growth\n"
        "Exit codes: 0 done, 1 failed, 2 wrong use.");
    return app;
}

Request parse_command_line(std::span<const std::string> arguments, Options& options) {
    const std::shared_ptr<CLI::App> app = define_command_line(options);
    refuse_unknown_command(*app, arguments);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
        app->parse(reversed);
    } catch (const CLI::CallForVersion& version) {
        return {{}, std::string(version.what()) + '\n'};
    } catch (const CLI::Success&) {
        return {{}, app->help()};
    } catch (const CLI::ParseError& error) {
        throw UsageError(explain_error(*app, error) + how_to_go_on(chosen(*app)));
    }
    return {chosen(*app).get_name(), {}};
}

}  // namespace edaha
