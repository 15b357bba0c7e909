// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "flatten/flatten_params.h"
#include "flatten/labelled_map.h"

namespace edaha {

// Which edges of the map the picture needs, for cut_arcs(): 0 for those that are dissolved, else
// 1 + the LineKind (edges between two labels that are no line: 1 + tone or 1 + none). `hidden`
// lines have kHiddenKind added.
inline constexpr std::uint32_t kHiddenKind = 16;

// Looks without fills need no borders of tones; the blueprint alone needs hidden lines.
std::vector<std::uint32_t> kept_edges(const LabelledMap& map, FlatLook look);

inline bool is_hidden_kind(std::uint32_t kind) {
    return kind > kHiddenKind;
}
inline LineKind line_of_kind(std::uint32_t kind) {
    return static_cast<LineKind>((kind - 1) % kHiddenKind);
}

}  // namespace edaha
