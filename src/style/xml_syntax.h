// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include <pugixml.hpp>

namespace edaha {

// What all strict readers of XML share.

// Nothing that XML can hold is dropped by the reader without our seeing it, but white space.
inline constexpr unsigned kParseAllXml = pugi::parse_default | pugi::parse_fragment |
                                         pugi::parse_doctype | pugi::parse_pi |
                                         pugi::parse_declaration | pugi::parse_comments;

// What is wrong with text that is no XML, for "malformed XML: broken end tag".
const char* xml_syntax_error(pugi::xml_parse_status status);

// Whether a declaration's encoding is UTF-8, the one that we read.
bool is_utf8(std::string_view encoding);

}  // namespace edaha
