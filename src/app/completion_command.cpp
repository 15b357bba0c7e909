// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <ostream>

#include <CLI/App.hpp>
#include <fmt/core.h>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/shell_word.h"
#include "style/parameter.h"
#include "style/value.h"
#include "write/format.h"

namespace edaha {
namespace {

// What may stand for a value, by the type that the command line names: a list of words, or words
// that a command prints, or files.
struct Words {
    std::string words;
    std::string command;
    bool files = false;
};

template <class Range, class Name>
std::string join(const Range& range, const Name& name) {
    std::string text;
    for (const auto& each : range) {
        if (!text.empty()) text += ' ';
        text += std::string(std::invoke(name, each));
    }
    return text;
}

// Of a parameter that is a choice.
Words names_of(const char* key) {
    const auto& choice = std::get<Choice>(find_parameter(key)->field);
    return {join(choice.names, [](const std::string& n) { return n; }), {}, false};
}

Words words_for(const std::string& type) {
    if (type == "STYLE") return {{}, "edaha styles --names", true};
    if (type == "FILE" || type == "DIR" || type == "MODEL") return {{}, {}, true};
    if (type == "MESHFORMAT") return {"obj ply", {}, false};
    if (type == "AXIS") return {"y z", {}, false};
    if (type == "FLATLOOK") return names_of("flatten.look");
    if (type == "PROJECTION") return names_of("flatten.projection");
    if (type == "FORMAT") return {join(kFormats, [](Format f) { return name(f); }), {}, false};
    if (type == "SHELL") return {"bash zsh fish", {}, false};
    if (type == "LOOK") return names_of("look.wood");
    if (type == "PARAMETER") {
        return {join(parameter_groups(), &ParameterGroup::name) + ' ' +
                    join(parameters(), &Parameter::key),
                {},
                false};
    }
    if (type == "GROUP.NAME=VALUE") {
        return {join(parameters(), [](const Parameter& p) { return p.key() + '='; }), {}, false};
    }
    return {};
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames())
        names.push_back('-' + name);
    for (const std::string& name : option.get_lnames())
        names.push_back("--" + name);
    return names;
}

std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional) {
    return app.get_options(
        [positional](const CLI::Option* option) { return option->get_positional() == positional; });
}

std::string all_names(const CLI::App& app) {
    return join(options_of(app, false), [](const CLI::Option* option) {
        return join(names_of(*option), [](const std::string& n) { return n; });
    });
}

// "STYLE", "FILE": of an option its value's type, of an argument its name.
std::string type_of(const CLI::Option& option) {
    return option.get_positional() ? option.get_name() : option.get_type_name();
}

bool takes_value(const CLI::Option& option) {
    return option.get_expected_max() > 0;
}

// ---- bash

std::string bash_reply(const Words& words) {
    std::string text;
    if (!words.words.empty() || !words.command.empty()) {
        const std::string list =
            words.command.empty() ? words.words : "$(" + words.command + " 2>/dev/null)";
        text = fmt::format("COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))", list);
    }
    if (words.files) {
        text += fmt::format("{}COMPREPLY+=($(compgen -f -- \"$word\"))", text.empty() ? "" : "; ");
    }
    if (words.words.ends_with('=')) text += "; compopt -o nospace 2>/dev/null";
    return text.empty() ? ":" : text;
}

std::string bash_command(const CLI::App& command) {
    std::string text = fmt::format("    {})\n      case \"$previous\" in\n", command.get_name());
    for (const CLI::Option* option : options_of(command, false)) {
        if (!takes_value(*option)) continue;
        const std::string names = join(names_of(*option), [](const std::string& n) { return n; });
        std::string pattern = names;
        std::ranges::replace(pattern, ' ', '|');
        text += fmt::format("        {}) {}; return ;;\n", pattern,
                            bash_reply(words_for(type_of(*option))));
    }
    text += "      esac\n";
    text += fmt::format(
        "      if [[ \"$word\" == -* ]]; then COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))\n",
        all_names(command));
    for (const CLI::Option* option : options_of(command, true)) {
        text += fmt::format("      else {}\n", bash_reply(words_for(type_of(*option))));
    }
    return text + "      fi ;;\n";
}

std::string bash_script(const CLI::App& app) {
    std::string text =
        "# Completion of edaha for bash: eval \"$(edaha completion bash)\"\n"
        "_edaha() {\n"
        "  local word=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
        "  COMPREPLY=()\n"
        "  if [[ $COMP_CWORD -eq 1 ]]; then\n";
    text += fmt::format(
        "    COMPREPLY=($(compgen -W \"{} {}\" -- \"$word\"))\n    return\n  fi\n",
        join(app.get_subcommands({}), [](const CLI::App* command) { return command->get_name(); }),
        all_names(app));
    text += "  case \"${COMP_WORDS[1]}\" in\n";
    for (const CLI::App* command : app.get_subcommands({}))
        text += bash_command(*command);
    return text +
           "  esac\n"
           "}\n"
           "complete -o filenames -F _edaha edaha\n";
}

// ---- zsh

std::string zsh_action(const std::string& type) {
    const Words words = words_for(type);
    if (!words.words.empty()) return '(' + words.words + ')';
    if (!words.command.empty())
        return "{_alternative \"a:style:($(" + words.command + "))\" \"f:file:_files\"}";
    return words.files ? "_files" : " ";
}

// _arguments takes [ ] and : for its own.
std::string zsh_text(std::string text) {
    std::erase_if(text, [](char c) { return c == '[' || c == ']'; });
    std::string escaped;
    for (const char c : text) {
        if (c == ':') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string zsh_command(const CLI::App& command) {
    std::string text = fmt::format("    {})\n      _arguments", command.get_name());
    for (const CLI::Option* option : options_of(command, false)) {
        const std::string help = zsh_text(option->get_description());
        for (const std::string& name : names_of(*option)) {
            const std::string type = type_of(*option);
            const std::string value =
                takes_value(*option) ? fmt::format(":{}:{}", zsh_text(type), zsh_action(type)) : "";
            text += fmt::format(" \\\n        {}",
                                in_single_quotes(fmt::format("{}[{}]{}", name, help, value)));
        }
    }
    for (const CLI::Option* option : options_of(command, true)) {
        const std::string type = type_of(*option);
        text +=
            fmt::format(" \\\n        {}",
                        in_single_quotes(fmt::format("*:{}:{}", zsh_text(type), zsh_action(type))));
    }
    return text + " ;;\n";
}

std::string zsh_script(const CLI::App& app) {
    std::string text =
        "#compdef edaha\n"
        "# Completion of edaha for zsh: edaha completion zsh >_edaha, in a folder of $fpath\n"
        "_edaha() {\n"
        "  if (( CURRENT == 2 )); then\n"
        "    local -a commands=(";
    for (const CLI::App* command : app.get_subcommands({})) {
        text += "\n      " +
                in_single_quotes(command->get_name() + ':' + zsh_text(command->get_description()));
    }
    text +=
        ")\n"
        "    _describe command commands\n"
        "    return\n"
        "  fi\n"
        "  local command=$words[2]\n"
        "  shift words\n"
        "  (( CURRENT-- ))\n"
        "  case $command in\n";
    for (const CLI::App* command : app.get_subcommands({}))
        text += zsh_command(*command);
    return text + "  esac\n}\ncompdef _edaha edaha\n";
}

// ---- fish

std::string fish_values(const std::string& type) {
    const Words words = words_for(type);
    const std::string list = words.command.empty() ? words.words : '(' + words.command + ')';
    std::string text = words.files ? "" : " -f";
    if (!list.empty()) text += " -a " + in_single_quotes(list);
    return text;
}

std::string fish_command(const CLI::App& command) {
    const std::string when =
        fmt::format("complete -c edaha -n '__fish_seen_subcommand_from {}'", command.get_name());
    std::string text;
    for (const CLI::Option* option : options_of(command, false)) {
        text += when;
        for (const std::string& name : option->get_snames())
            text += " -s " + name;
        for (const std::string& name : option->get_lnames())
            text += " -l " + name;
        if (takes_value(*option)) text += " -r" + fish_values(type_of(*option));
        text += " -d " + in_single_quotes(option->get_description()) + '\n';
    }
    for (const CLI::Option* option : options_of(command, true))
        text += when + fish_values(type_of(*option)) + '\n';
    return text;
}

std::string fish_script(const CLI::App& app) {
    std::string text = "# Completion of edaha for fish: edaha completion fish | source\n";
    for (const CLI::App* command : app.get_subcommands({})) {
        text += fmt::format("complete -c edaha -f -n __fish_use_subcommand -a {} -d {}\n",
                            command->get_name(), in_single_quotes(command->get_description()));
        text += fish_command(*command);
    }
    return text;
}

}  // namespace

int print_completion(const Options& options, Console& console) {
    Options unused;
    const auto app = define_command_line(unused);
    if (options.shell == "bash") {
        console.out << bash_script(*app);
    } else if (options.shell == "zsh") {
        console.out << zsh_script(*app);
    } else if (options.shell == "fish") {
        console.out << fish_script(*app);
    } else {
        throw UsageError(fmt::format("completion: {} is not known (expected bash, zsh or fish)",
                                     in_quotes(options.shell)));
    }
    return 0;
}

}  // namespace edaha
