// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "flatten/labelled_map.h"
#include "flatten/view.h"

namespace edaha::test {

// Which part is seen at the middle of each pixel, kNone for none: an oracle for the map, made in
// another way (triangles painted into a depth buffer, no rays, no map).
struct IdBuffer {
    int size = 0;  // pixels a side
    std::vector<std::uint32_t> part;

    std::uint32_t at(int x, int y) const {
        const bool inside = x >= 0 && y >= 0 && x < size && y < size;
        return inside ? part[static_cast<std::size_t>(y * size + x)] : kNone;
    }
};

IdBuffer paint_depth(const Mesh& mesh, const View& view, int size);

// The same from the labels of the map's faces.
IdBuffer paint_map(const LabelledMap& map, int size);

struct Disagreement {
    std::size_t covered = 0, differ = 0;
    // That differ, and show what is nowhere to be seen within one pixel, or two, of them.
    std::size_t far = 0, very_far = 0;
};

// `fine` is the truth again with kFine times the pixels a side, so that it has thin slivers too.
inline constexpr int kFine = 4;
Disagreement compare(const IdBuffer& truth, const IdBuffer& fine, const IdBuffer& other);

}  // namespace edaha::test
