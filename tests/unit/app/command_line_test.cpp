// SPDX-License-Identifier: MIT
#include "app/command_line.h"

#include <set>

#include <CLI/App.hpp>
#include <gtest/gtest.h>

namespace edaha {
namespace {

std::string usage_error(const std::vector<std::string>& arguments) {
    Options options;
    try {
        parse_command_line(arguments, options);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

TEST(CommandLine, OptionsAreKeptAsWritten) {
    Options options;
    const std::vector<std::string> arguments = {"draw",   "--set", "a=1",    "oak", "--set", "b=2",
                                                "--seed", "1",     "--seed", "x",   "-o",    "-"};
    EXPECT_EQ(parse_command_line(arguments, options).command, "draw");
    EXPECT_EQ(options.tree.style, "oak");
    EXPECT_EQ(options.tree.assignments, (std::vector<std::string>{"a=1", "b=2"}));
    ASSERT_EQ(options.tree.settings.size(), 1U);
    EXPECT_EQ(options.tree.settings[0].key, "variant.seed");
    EXPECT_EQ(options.tree.settings[0].value, "x");  // the last one holds
    EXPECT_EQ(options.output, "-");
}

TEST(CommandLine, NegativeValuesAreNoOptions) {
    Options options;
    const std::vector<std::string> arguments = {"draw", "oak", "--vary", "-1"};
    parse_command_line(arguments, options);
    ASSERT_EQ(options.tree.settings.size(), 1U);
    EXPECT_EQ(options.tree.settings[0].value, "-1");
}

TEST(CommandLine, WrongUseIsExplained) {
    EXPECT_EQ(usage_error({}), "a command is missing\nTry 'edaha --help'.");
    EXPECT_EQ(usage_error({"drwa"}),
              "there is no command 'drwa' (did you mean 'draw'?)\nTry 'edaha --help'.");
    EXPECT_EQ(usage_error({"prune"}), "there is no command 'prune'\nTry 'edaha --help'.");
    EXPECT_EQ(usage_error({"draw"}), "draw: STYLE is missing\nTry 'edaha draw --help'.");
    EXPECT_EQ(usage_error({"draw", "oak", "--sed=3"}),
              "draw: there is no option '--sed' (did you mean '--seed'?)\n"
              "Try 'edaha draw --help'.");
    EXPECT_EQ(usage_error({"draw", "oak", "elm"}),
              "draw: 'elm' is one argument too many\nTry 'edaha draw --help'.");
    EXPECT_EQ(usage_error({"draw", "oak", "--seed"}),
              "draw: --seed needs a value\nTry 'edaha draw --help'.");
    EXPECT_EQ(usage_error({"--versio"}),
              "edaha: there is no option '--versio' (did you mean '--version'?)\n"
              "Try 'edaha --help'.");
}

TEST(CommandLine, EveryCommandHasHelpWithAnExample) {
    Options options;
    const auto app = define_command_line(options);
    for (const CLI::App* command : app->get_subcommands({})) {
        Options unused;
        const std::vector<std::string> arguments = {command->get_name(), "--help"};
        const Request request = parse_command_line(arguments, unused);
        EXPECT_EQ(request.command, "");
        const std::size_t example = request.text.find("\nExample");
        ASSERT_NE(example, std::string::npos) << request.text;
        EXPECT_NE(request.text.find("edaha " + command->get_name(), example), std::string::npos)
            << request.text;
        for (const CLI::Option* option : command->get_options())
            EXPECT_FALSE(option->get_description().empty()) << option->get_name();
    }
}

}  // namespace
}  // namespace edaha
