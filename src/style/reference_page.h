// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace edaha {

// The parameter table as a page in Markdown: one table a group, one line a parameter.
std::string reference_page();

}  // namespace edaha
