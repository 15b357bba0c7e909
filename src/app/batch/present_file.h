// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "write/format.h"

namespace edaha {

// A file that may be there already.
struct PresentFile {
    std::string path;
    Format format = Format::svg;
    bool may_be_foreign = false;  // to be overwritten even if no edaha has written it
};

// Whether it is there, whole, and records this recipe. Errors: IoError if it can't be read, or if
// it is foreign and must not be.
bool has_recipe(const PresentFile& file, const std::string& recipe);

}  // namespace edaha
