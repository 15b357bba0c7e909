// SPDX-License-Identifier: MIT
#include "write/xml_text.h"

#include <cstdint>

#include "base/utf8.h"

namespace edaha {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

bool allowed_in_xml(std::int32_t code) {
    if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
    return code != 0xfffe && code != 0xffff;
}

}  // namespace

std::string xml_safe(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    while (!text.empty()) {
        const auto [code, bytes] = first_character(text);
        if (code == kNoCharacter) {
            safe += kReplacement;
        } else if (allowed_in_xml(code)) {
            safe += text.substr(0, bytes);
        }
        text.remove_prefix(bytes);
    }
    return safe;
}

}  // namespace edaha
