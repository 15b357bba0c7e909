// SPDX-License-Identifier: MIT
#include "app/shell_word.h"

#include <string_view>

namespace edaha {

std::string shell_word(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=+:,%@";
    const bool plain = !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
    return plain ? word : in_single_quotes(word);
}

std::string in_single_quotes(const std::string& word) {
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + '\'';
}

}  // namespace edaha
