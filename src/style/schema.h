// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace edaha {

// The parameter table as an XML Schema (XSD 1.0), for editors that complete and check style files.
// It accepts every style that read_style accepts in canonical form; it knows names, kinds and
// ranges, but not which drawings and styles there are, nor that a range must not be reversed.
std::string style_schema();

}  // namespace edaha
