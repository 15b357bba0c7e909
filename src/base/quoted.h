// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace edaha {

// 'text' for a message: shortened to 40 bytes, without line ends and broken UTF-8.
std::string quoted(std::string_view text);

// Without the blanks and line ends at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace edaha
