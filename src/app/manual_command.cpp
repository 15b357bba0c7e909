// SPDX-License-Identifier: MIT
#include <ostream>

#include <CLI/App.hpp>
#include <fmt/core.h>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/version.h"
#include "style/parameter.h"

namespace edaha {
namespace {

// Text for roff (man(7)): its escape character doubled, hyphens that a user types kept as such, a
// control character at a line's start made harmless.
std::string roff(const std::string& text) {
    std::string escaped;
    bool line_start = true;
    for (const char c : text) {
        if (line_start && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\') {
            escaped += "\\e";
        } else if (c == '-') {
            escaped += "\\-";
        } else {
            escaped += c;
        }
        line_start = c == '\n';
    }
    return escaped;
}

std::string option_lines(const CLI::App& command) {
    std::string text;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) continue;
        std::string names;
        for (const std::string& name : option->get_snames())
            names += "\\fB" + roff('-' + name) + "\\fR, ";
        for (const std::string& name : option->get_lnames())
            names += "\\fB" + roff("--" + name) + "\\fR";
        if (option->get_expected_max() > 0)
            names += " \\fI" + roff(option->get_type_name()) + "\\fR";
        text += ".TP\n" + names + '\n' + roff(option->get_description()) + '\n';
    }
    return text;
}

std::string command_section(const CLI::App& command) {
    std::string synopsis = "\\fBedaha " + command.get_name() + "\\fR [options]";
    std::string arguments;
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional()) continue;
        const std::string type = option->get_name();
        synopsis += (option->get_required() ? " \\fI" + type + "\\fR" : " [\\fI" + type + "\\fR]") +
                    (option->get_expected_max() > 1 ? "..." : "");
        arguments += ".TP\n\\fI" + type + "\\fR\n" + roff(option->get_description()) + '\n';
    }
    std::string text = ".SS " + command.get_name() + "\n" + synopsis + "\n.PP\n" +
                       roff(command.get_description()) + ".\n" + arguments + option_lines(command);
    return text + ".PP\n.nf\n" + roff(command.get_footer()) + "\n.fi\n";
}

std::string parameter_section() {
    std::string text;
    for (const ParameterGroup& group : parameter_groups()) {
        text += ".TP\n\\fB" + group.name + "\\fR\n" + roff(group.help) + ": ";
        for (const Parameter& parameter : group.parameters) {
            text += roff(parameter.name) + (&parameter == &group.parameters.back() ? ".\n" : ", ");
        }
    }
    return text;
}

}  // namespace

int print_manual(const Options&, Console& console) {
    Options unused;
    const auto app = define_command_line(unused);
    console.out
        << fmt::format(".TH EDAHA 1 \"\" \"edaha {}\" \"User commands\"\n", kVersion)
        << ".SH NAME\nedaha \\- draws trees as flat, editable vector illustrations\n"
        << ".SH SYNOPSIS\n\\fBedaha\\fR \\fIcommand\\fR [options]\n"
        << ".SH DESCRIPTION\n"
        << "Grows a tree of a style, by name or from a file, and writes it as SVG, PDF, PNG "
           "or EPS.\nThe same style, seed and version give the same bytes anywhere.\n"
        << ".SH COMMANDS\n";
    for (const CLI::App* command : app->get_subcommands({}))
        console.out << command_section(*command);
    console.out
        << ".SH PARAMETERS\nWhat \\fB\\-\\-set\\fR and style files can set, by group; "
           "\\fBedaha explain\\fR says more.\n"
        << parameter_section()
        << ".SH FILES\n.TP\n~/.local/share/edaha/styles/, ~/.local/share/edaha/leaves/\n"
           "Styles and leaf drawings of your own. They come before those that are built in. "
           "$XDG_DATA_HOME replaces ~/.local/share.\n"
        << ".SH EXIT STATUS\n0 done, 1 failed, 2 wrong use.\n";
    return 0;
}

}  // namespace edaha
