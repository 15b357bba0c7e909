// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/options.h"

namespace edaha {

// The batch command that draws the same files again, in one fixed order of options and without
// those that decide only where, how fast, which share, and what happens to files that are there.
std::string plan_command(const Options& options);

}  // namespace edaha
