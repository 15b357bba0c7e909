// SPDX-License-Identifier: MIT
#pragma once
#include "app/options.h"

namespace CLI {
class App;
}

namespace edaha {

// Adds the command "batch" with its options. Keeps references to `options`.
void add_batch(CLI::App& app, Options& options);

}  // namespace edaha
