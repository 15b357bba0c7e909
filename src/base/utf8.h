// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace edaha {

// The character that a text, which is not empty, starts with: RFC 3629, shortest form, no
// surrogates. A byte that starts none is kNoCharacter, one byte long.
struct Utf8Character {
    std::int32_t code = 0;
    std::size_t bytes = 1;
};
inline constexpr std::int32_t kNoCharacter = -1;

Utf8Character first_character(std::string_view text);

}  // namespace edaha
