// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <iosfwd>

namespace edaha {

// What a command may touch besides the files that it is told to.
struct Console {
    std::istream& in;
    std::ostream& out;                  // results
    std::ostream& err;                  // messages
    std::filesystem::path user_folder;  // with the user's own styles/ and leaves/; may be empty
    std::size_t err_columns = 0;        // if `err` is a terminal; else 0
    int ended_by_signal = 0;            // set by a command that a signal stopped: main ends by it
};

}  // namespace edaha
