// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "drawing/drawing.h"

namespace edaha {

class XmlWriter;

// Writes <title>, <desc> and <metadata> into an <svg> element: Dublin Core in RDF for others,
// <edaha:tree version seed recipe> with <edaha:command> and <edaha:style> for us, the style as
// text, to the letter. Parts that are empty are left out.
void write_metadata(XmlWriter& svg, const Metadata& metadata);

// What write_metadata wrote, also after an editor has saved the file anew. `svg` may be gzipped.
// Nothing if it is no SVG, or none of ours. (An XML reader turns CR LF into LF: so does this.)
// Errors: IoError for a gzipped file that is damaged or unpacks to more than `max_bytes`.
std::optional<Metadata> read_svg_metadata(std::string_view svg,
                                          std::size_t max_bytes = std::size_t{1} << 30);

}  // namespace edaha
