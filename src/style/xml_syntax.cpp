// SPDX-License-Identifier: MIT
#include "style/xml_syntax.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace edaha {

const char* xml_syntax_error(pugi::xml_parse_status status) {
    switch (status) {
        case pugi::status_bad_pi:
            return "broken processing instruction or declaration";
        case pugi::status_bad_comment:
            return "comment without end";
        case pugi::status_bad_cdata:
            return "CDATA without end";
        case pugi::status_bad_doctype:
            return "broken document type";
        case pugi::status_bad_pcdata:
            return "broken text";
        case pugi::status_bad_start_element:
            return "broken start tag";
        case pugi::status_bad_attribute:
            return "broken attribute";
        case pugi::status_bad_end_element:
            return "broken end tag";
        case pugi::status_end_element_mismatch:
            return "a start tag and an end tag do not match";
        default:
            return "broken tag";
    }
}

bool is_utf8(std::string_view encoding) {
    std::string lower;
    std::ranges::transform(encoding, std::back_inserter(lower), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower == "utf-8" || lower == "utf8";
}

}  // namespace edaha
