// SPDX-License-Identifier: MIT
#include "write/xml_text.h"

#include <cstdint>

namespace edaha {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

// Bytes that the sequence with this first byte has; 0 if none starts so.
std::size_t sequence_length(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return 2;
    if (first >= 0xe0 && first < 0xf0) return 3;
    if (first >= 0xf0 && first < 0xf5) return 4;
    return 0;
}

// The character at the start of `text` (RFC 3629: shortest form, no surrogates), or -1.
std::int32_t decode(std::string_view text, std::size_t length) {
    if (length == 0 || length > text.size()) return -1;
    const auto first = static_cast<unsigned char>(text[0]);
    std::int32_t code = length == 1 ? first : first & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xc0) != 0x80) return -1;
        code = code << 6 | (byte & 0x3f);
    }
    const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return too_long || surrogate || code > 0x10ffff ? -1 : code;
}

bool allowed_in_xml(std::int32_t code) {
    if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
    return code != 0xfffe && code != 0xffff;
}

}  // namespace

std::string xml_safe(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequence_length(static_cast<unsigned char>(text[0]));
        const std::int32_t code = decode(text, length);
        if (code < 0) {
            safe += kReplacement;
            text.remove_prefix(1);
            continue;
        }
        if (allowed_in_xml(code)) safe += text.substr(0, length);
        text.remove_prefix(length);
    }
    return safe;
}

}  // namespace edaha
