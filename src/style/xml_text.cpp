// SPDX-License-Identifier: MIT
#include "style/xml_text.h"

#include <cstdint>

namespace edaha {
namespace {

struct Lead {
    std::size_t length;
    std::uint32_t bits;
    std::uint32_t least;  // smaller code points have a shorter form
};

Lead read_lead(unsigned char byte) {
    if (byte < 0x80U) return {1, byte, 0};
    if ((byte & 0xE0U) == 0xC0U) return {2, byte & 0x1FU, 0x80};
    if ((byte & 0xF0U) == 0xE0U) return {3, byte & 0x0FU, 0x800};
    if ((byte & 0xF8U) == 0xF0U) return {4, byte & 0x07U, 0x10000};
    return {0, 0, 0};
}

bool is_xml_character(std::uint32_t c) {
    if (c < 0x20) return c == '\t' || c == '\n' || c == '\r';
    return c < 0xD800 || (c > 0xDFFF && c < 0xFFFE) || (c > 0xFFFF && c <= 0x10FFFF);
}

// Length of the character that `text` begins with; 0 if it is none that XML allows.
std::size_t character_length(std::string_view text) {
    const Lead lead = read_lead(static_cast<unsigned char>(text[0]));
    if (lead.length == 0 || lead.length > text.size()) return 0;
    std::uint32_t c = lead.bits;
    for (std::size_t i = 1; i < lead.length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xC0U) != 0x80U) return 0;
        c = c << 6U | (byte & 0x3FU);
    }
    return c >= lead.least && is_xml_character(c) ? lead.length : 0;
}

}  // namespace

std::optional<std::size_t> first_byte_not_xml(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = character_length(text.substr(at));
        if (length == 0) return at;
        at += length;
    }
    return std::nullopt;
}

}  // namespace edaha
