// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace edaha {

// Puts the manifests of all shares of a run together, in `folder`: the very manifest.csv and .json
// that the whole run would have written. Without paths, the shares' manifests in the folder are
// taken. Returns the number of variants. The shares stay.
// Errors: IoError if shares are of different runs, missing, given twice or not complete; without
// `force` also where the folder has the manifest of another run.
std::size_t merge_manifests(const std::string& folder, std::vector<std::string> paths,
                            bool force = false);

}  // namespace edaha
