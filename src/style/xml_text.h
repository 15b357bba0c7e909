// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace edaha {

// Offset of the first byte that XML 1.0 in UTF-8 does not allow (section 2.2): a broken, overlong
// or surrogate sequence, U+FFFE, U+FFFF, a control character other than tab and line ends.
std::optional<std::size_t> first_byte_not_xml(std::string_view text);

}  // namespace edaha
