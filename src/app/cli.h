// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "app/console.h"

namespace edaha {

// The whole program but main(): runs the command line (without the program's name) and returns the
// exit code: 0 done, 1 failed, 2 wrong use. Whatever goes wrong is said on console.err.
int run(std::span<const std::string> arguments, Console& console);

}  // namespace edaha
