// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "app/batch/stop_signals.h"
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

// One tree's memory serves the next one, in large pages where the system has them: given back and
// asked for again page by page, it would cost a fifth of the time of drawing, and a third of that
// of flattening a large mesh.
void keep_freed_memory() {
#if defined(__GLIBC__)
    constexpr int kRoom = 1 << 30;  // of addresses: what is not used takes no memory
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    mallopt(M_TOP_PAD, kRoom);
    void* volatile taken = std::malloc(1 << 20);  // volatile: or nothing is asked for
    std::free(taken);
    char* const end = static_cast<char*>(sbrk(0));
    madvise(end - kRoom, kRoom, MADV_HUGEPAGE);  // fails where less was granted: no harm
    mallopt(M_TOP_PAD, 64 << 20);
#endif
}

// Of the terminal that messages go to; 0 if they go elsewhere.
std::size_t columns_of_messages() {
    if (::isatty(STDERR_FILENO) == 0) return 0;
    winsize size{};
    const bool told = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return told ? size.ws_col : 80;
}

}  // namespace

int main(int argc, char** argv) {
    keep_freed_memory();
    // A reader that goes away, or a file above the user's limit, is then an error of writing, which
    // has a message.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    std::ios::sync_with_stdio(false);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    edaha::Console console{std::cin, std::cout, std::cerr, user_folder(), columns_of_messages()};
    const int code = edaha::run(arguments, console);
    if (console.ended_by_signal != 0) edaha::end_by_signal(console.ended_by_signal);
    return code;
}
