// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace edaha {

// `text` as an XML 1.0 document may hold it: control characters but tab and line ends are left out,
// bytes that are no UTF-8 (a file name on a command line, say) become U+FFFD. Nothing is escaped.
std::string xml_safe(std::string_view text);

// Appends the same, escaped as its place asks for: an attribute's value stands in double quotes.
// About 1 ns a byte where nothing is to be done.
enum class XmlPlace { text, attribute };
void append_xml(std::string& to, std::string_view text, XmlPlace place);

}  // namespace edaha
