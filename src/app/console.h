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
};

}  // namespace edaha
