// SPDX-License-Identifier: MIT
#include "app/cli.h"

#include <cerrno>
#include <cstring>
#include <map>
#include <new>
#include <ostream>
#include <string_view>

#include "app/command_line.h"
#include "app/commands.h"
#include "base/error.h"

namespace edaha {
namespace {

int run_command(const std::string& name, const Options& options, Console& console) {
    static const std::map<std::string_view, int (*)(const Options&, Console&)> kCommands = {
        {"draw", draw},         {"batch", batch},          {"gallery", make_gallery},
        {"measure", measure},   {"styles", list_styles},   {"leaves", list_leaves},
        {"check", check_files}, {"explain", explain},      {"completion", print_completion},
        {"man", print_manual},  {"flatten", flatten_file}, {"mesh", write_mesh},
    };
    return kCommands.at(name)(options, console);
}

int run_unguarded(std::span<const std::string> arguments, Console& console) {
    Options options;
    const Request request = parse_command_line(arguments, options);
    int code = 0;
    errno = 0;
    if (request.command.empty()) {
        console.out << request.text;
    } else {
        code = run_command(request.command, options, console);
    }
    console.out.flush();
    if (!console.out) {
        throw IoError(std::string("cannot write to standard output") +
                      (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
    }
    return code;
}

}  // namespace

int run(std::span<const std::string> arguments, Console& console) {
    try {
        return run_unguarded(arguments, console);
    } catch (const UsageError& error) {
        console.err << "edaha: " << error.what() << '\n';
        return 2;
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems()) {
            if (problem.place.file.empty()) console.err << "edaha: ";
            console.err << to_string(problem) << '\n';
        }
    } catch (const std::bad_alloc&) {
        console.err << "edaha: there is not enough memory for this\n";
    } catch (const std::exception& error) {
        console.err << "edaha: " << error.what() << '\n';
    }
    return 1;
}

}  // namespace edaha
