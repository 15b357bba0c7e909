// SPDX-License-Identifier: MIT
#include "base/locate.h"

#include <algorithm>

namespace edaha {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kSpace = " \t\r\n";

std::size_t skip(std::string_view text, std::size_t at, std::string_view any_of) {
    return std::min(text.find_first_not_of(any_of, at), text.size());
}

std::size_t find(std::string_view text, std::size_t at, std::string_view any_of) {
    return std::min(text.find_first_of(any_of, at), text.size());
}

bool continues_code_point(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

struct AttributeSpan {
    std::size_t name;
    std::size_t value;
};

// Walks name = "value" pairs until the wanted one or the tag's end.
AttributeSpan find_attribute(std::string_view text, std::size_t node, std::string_view name) {
    std::size_t at = find(text, node, " \t\r\n/>");
    while (true) {
        at = skip(text, at, kSpace);
        if (at >= text.size() || text[at] == '>' || text[at] == '/') return {node, node};
        const std::size_t name_end = find(text, at, " \t\r\n=/>");
        const std::size_t quote = skip(text, name_end, " \t\r\n=");
        if (quote >= text.size() || (text[quote] != '"' && text[quote] != '\'')) {
            return {node, node};
        }
        if (text.substr(at, name_end - at) == name) return {at, quote + 1};
        const std::size_t value_end = find(text, quote + 1, text.substr(quote, 1));
        at = std::min(value_end + 1, text.size());
    }
}

}  // namespace

Place place_of_offset(std::string_view text, std::size_t offset, const std::string& file) {
    const std::size_t end = std::min(offset, text.size());
    Place place{file, 1, 1};
    for (std::size_t i = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; i < end;
         ++i) {
        const bool ends_line =
            text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'));
        if (ends_line) {
            ++place.line;
            place.column = 1;
        } else if (!continues_code_point(text[i])) {
            ++place.column;
        }
    }
    return place;
}

std::size_t attribute_offset(std::string_view text, std::size_t node_offset,
                             std::string_view name) {
    return find_attribute(text, std::min(node_offset, text.size()), name).name;
}

std::size_t attribute_value_offset(std::string_view text, std::size_t node_offset,
                                   std::string_view name) {
    return find_attribute(text, std::min(node_offset, text.size()), name).value;
}

std::size_t offset_in_value(std::string_view text, std::size_t value_offset, std::size_t index) {
    std::size_t at = std::min(value_offset, text.size());
    for (; index > 0 && at < text.size(); --index) {
        if (text[at] == '&') {
            at = std::min(text.find(';', at), text.size() - 1);
        } else if (text.substr(at).starts_with("\r\n")) {
            ++at;
        }
        ++at;
    }
    return at;
}

}  // namespace edaha
