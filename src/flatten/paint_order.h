// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "flatten/labelled_map.h"

namespace edaha {

// What is painted when: parts from far to near, and within a part first all of it in its base
// tone, then the areas of other tones on top.
struct PaintOrder {
    struct Part {
        std::uint32_t part = 0;
        std::uint8_t base = 0;  // tone
        double nearness = 0;    // of its middle, 0 for the farthest part to 1 for the nearest
    };
    std::vector<Part> parts;          // those that are seen, far to near
    std::vector<std::uint32_t> rank;  // a part: its place among them from 1 on; 0 if not seen

    // When what is seen in a label is painted: later is larger, 0 for the background.
    std::uint32_t time(FaceLabel label) const {
        if (label.part == kNone) return 0;
        const Part& part = parts[rank[label.part] - 1];
        return time_of_base(label.part) + (label.tone == part.base ? 0 : 1 + label.tone);
    }
    std::uint32_t time_of_base(std::uint32_t part) const { return rank[part] * 16; }
};

// The base of a part is the middle one of `bands` tones if that is seen, else the one that is seen
// most. O(faces + parts log parts).
PaintOrder paint_order(const LabelledMap& map, std::size_t parts, int bands);

}  // namespace edaha
