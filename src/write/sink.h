// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string_view>

namespace edaha {

// Where a writer's bytes go, in order, in pieces: an AtomicFile's write, standard output, a string.
using Sink = std::function<void(std::string_view)>;

}  // namespace edaha
