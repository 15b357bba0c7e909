// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"

namespace edaha {

// From byte offsets in a UTF-8 text, XML above all, to places a person can go to. XML readers keep
// where an element's name begins and no more, so the places of attributes are found by scanning
// the tag again. Offsets beyond the end count as the end. Cost: linear in the offset.

// Line and column from 1; a column is a code point. Lines end in LF, CR LF or CR; a byte order mark
// takes no column.
Place place_of_offset(std::string_view text, std::size_t offset, const std::string& file);

// Where the attribute `name` begins in the tag whose element name begins at `node_offset` (what
// pugixml's offset_debug() gives); `node_offset` if the tag has no such attribute.
std::size_t attribute_offset(std::string_view text, std::size_t node_offset, std::string_view name);

// The same for the first byte of its value, behind the quote.
std::size_t attribute_value_offset(std::string_view text, std::size_t node_offset,
                                   std::string_view name);

// The source offset of byte `index` of a value that begins at `value_offset`, counting CR LF and a
// reference (&#10; &quot;) as one byte each, as they are after reading.
std::size_t offset_in_value(std::string_view text, std::size_t value_offset, std::size_t index);

}  // namespace edaha
