// SPDX-License-Identifier: MIT
#include "base/utf8.h"

namespace edaha {
namespace {

// Bytes that the sequence with this first byte has; 0 if none starts so.
std::size_t sequence_length(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return 2;
    if (first >= 0xe0 && first < 0xf0) return 3;
    if (first >= 0xf0 && first < 0xf5) return 4;
    return 0;
}

std::int32_t decode(std::string_view text, std::size_t length) {
    if (length == 0 || length > text.size()) return kNoCharacter;
    const auto first = static_cast<unsigned char>(text[0]);
    std::int32_t code = length == 1 ? first : first & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xc0) != 0x80) return kNoCharacter;
        code = code << 6 | (byte & 0x3f);
    }
    const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return too_long || surrogate || code > 0x10ffff ? kNoCharacter : code;
}

}  // namespace

Utf8Character first_character(std::string_view text) {
    const std::size_t length = sequence_length(static_cast<unsigned char>(text[0]));
    const std::int32_t code = decode(text, length);
    return {code, code == kNoCharacter ? 1 : length};
}

}  // namespace edaha
