// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

// The known name that somebody who wrote `wrong` most likely meant, for "did you mean": the fewest
// insertions, deletions, replacements and swaps of neighbours (Damerau 1964, Levenshtein 1966, in
// the form where no piece is edited twice), capitals being as good as small letters. None if that
// takes more than max(1, length / 3) steps. Ties: the first. Cost: |wrong| x |name| for each name.
std::optional<std::string> nearest_name(std::string_view wrong, std::span<const std::string> known);

// " (did you mean 'oak'?)", for the end of a message; empty if there is no such name.
std::string did_you_mean(std::string_view wrong, const std::vector<std::string>& known);

}  // namespace edaha
