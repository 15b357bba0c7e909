// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace edaha {

// `text` as an XML 1.0 document may hold it: control characters but tab and line ends are left out,
// bytes that are no UTF-8 (a file name on a command line, say) become U+FFFD. Escaping is
// pugixml's.
std::string xml_safe(std::string_view text);

}  // namespace edaha
