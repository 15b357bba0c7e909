// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <string>

#include "app/options.h"

namespace CLI {
class App;
}

namespace edaha {

// The definition of every command and option. Help, completion and the manual page are made from
// it too. Keeps references to `options`, which parsing fills.
std::shared_ptr<CLI::App> define_command_line(Options& options);

// What the arguments ask for: a command's name, with its options filled in; or a text to print.
struct Request {
    std::string command;
    std::string text;  // --help, --version; then there is no command
};

// Errors: UsageError, with "did you mean" for commands and options.
Request parse_command_line(std::span<const std::string> arguments, Options& options);

}  // namespace edaha
