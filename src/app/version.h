// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// EDAHA_VERSION comes from the project() line of the top CMakeLists.txt.
inline constexpr const char* kVersion = EDAHA_VERSION;

}  // namespace edaha
