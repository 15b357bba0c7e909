// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace edaha::test {

// The names of a PDF file's layers as programs list them, top first. Throws if qpdf warns of the
// file.
std::vector<std::string> pdf_layers(const std::string& pdf);

// The same file with one layer of that list switched off.
std::string with_layer_off(const std::string& pdf, std::size_t index);

}  // namespace edaha::test
