// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/leaf_shelf.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/tree_style.h"
#include "write/format.h"

namespace edaha {

// From a tree's style to its picture's files, for every command that writes some. The same style
// and options give the same bytes, whichever command it is.

// "svg". Errors: UsageError.
Format parse_format(const std::string& name);

// Errors: UsageError.
WriteParams write_params(const WriteOptions& options, const Style& style);

// What each file of a picture records of how it was made. Its recipe tells whether a file is still
// what would be drawn: it depends on the version, the command, the style's values, the texts of its
// leaf drawings and the options of writing. No drawing is needed for it.
Metadata metadata_of(const TreeStyle& tree, const WriteParams& params, LeafShelf& leaves);

// The members that options can set, for recipes.
std::string text_of(const WriteParams& params);

// Writes the drawing into a file that appears whole or not at all. Errors: IoError.
WriteReport write_file(const Drawing& drawing, const std::string& path, Format format,
                       const WriteParams& params);

// What of the leaf drawings is not kept, and what programs may not read.
std::vector<std::string> warnings(const Picture& picture, const SvgReport& report);

}  // namespace edaha
