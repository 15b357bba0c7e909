// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace edaha {

// A word of a command line, so that a shell reads it back as it is.
std::string shell_word(const std::string& word);

// The same, in quotes even where it needs none.
std::string in_single_quotes(const std::string& word);

}  // namespace edaha
