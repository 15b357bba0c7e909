// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/console.h"
#include "app/options.h"
#include "write/format.h"

namespace edaha {

// Where the picture of a command goes.
struct Target {
    std::string file;  // "-": standard output
    Format format;
};

// As -o, --format and --force say; without -o into "NAME.svg" in the working folder. Errors:
// UsageError, and IoError for a file that is there already.
Target choose_target(const Options& options, const std::string& name);

// Errors: IoError if the file is there and `force` is not set.
void refuse_existing(const std::string& file, bool force);

// Errors: IoError.
WriteReport write_target(const Drawing& drawing, const Target& target, const WriteParams& params,
                         Console& console);

}  // namespace edaha
