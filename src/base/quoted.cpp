// SPDX-License-Identifier: MIT
#include "base/quoted.h"

#include "base/utf8.h"

namespace edaha {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f";

}  // namespace

std::string quoted(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    std::string kept = "'";
    while (!text.empty()) {
        if (kept.size() > kLongest) {
            kept += "...";
            break;
        }
        const Utf8Character first = first_character(text);
        const bool blank = kSpace.find(text.front()) != std::string_view::npos;
        if (first.code >= ' ' && first.code != 0x7f) {
            kept += text.substr(0, first.bytes);
        } else {
            kept += blank ? ' ' : '?';
        }
        text.remove_prefix(first.bytes);
    }
    return kept + '\'';
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

}  // namespace edaha
