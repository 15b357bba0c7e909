// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "app/cli.h"

namespace {

// $XDG_DATA_HOME/edaha, or ~/.local/share/edaha (XDG base directory specification).
std::filesystem::path user_folder() {
    const char* const data = std::getenv("XDG_DATA_HOME");
    if (data != nullptr && *data == '/') return std::filesystem::path(data) / "edaha";
    const char* const home = std::getenv("HOME");
    if (home == nullptr || *home != '/') return {};
    return std::filesystem::path(home) / ".local/share/edaha";
}

// One tree's memory serves the next one: given back to the system and asked for again, it would
// cost a fifth of the time of drawing.
void keep_freed_memory() {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    mallopt(M_MMAP_THRESHOLD, 16 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    keep_freed_memory();
    // A reader that goes away is then an error of writing, which has a message.
    std::signal(SIGPIPE, SIG_IGN);
    std::ios::sync_with_stdio(false);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    edaha::Console console{std::cin, std::cout, std::cerr, user_folder()};
    return edaha::run(arguments, console);
}
