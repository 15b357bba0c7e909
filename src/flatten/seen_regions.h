// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "flatten/labelled_map.h"
#include "geometry/region_rings.h"

namespace edaha {

// Labels as numbers for trace_region_rings(): 0 is the background.
inline constexpr std::uint32_t kTonesPerPart = 8;
inline std::uint32_t code_of(FaceLabel label) {
    if (label.part == kNone) return 0;
    const std::uint32_t tone = label.tone < kTonesPerPart ? label.tone : kTonesPerPart - 1;
    return label.part * kTonesPerPart + tone + 1;
}
inline FaceLabel label_of(std::uint32_t code) {
    if (code == 0) return {};
    return {(code - 1) / kTonesPerPart, static_cast<std::uint8_t>((code - 1) % kTonesPerPart)};
}

// What is seen as regions of one label, with their rings and how wide they are.
struct SeenRegions {
    RegionRings rings;         // labels are codes
    std::vector<float> width;  // a half-edge: of the region to its left, in pixels
};

// Widths are mean ones, 2 area / perimeter of the outline; infinite for the background and at
// holes. O(E).
SeenRegions find_regions(const LabelledMap& map);

}  // namespace edaha
