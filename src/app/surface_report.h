// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "surface/grow_surface.h"

namespace edaha {

// Adds what surface growth tells of a run, under keys that stay: "steps", "vertices", "faces" …
// No time: that is for --stats, so that a report is the same each time.
void add_to_json(nlohmann::ordered_json& json, const SurfaceReport& report);

}  // namespace edaha
