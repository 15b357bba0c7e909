// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <unordered_map>

#include "prism/prism.h"

namespace edaha {

// Whether two prisms have inner points in common; those that only touch have none. Exact but for
// rounding: a millionth of their size is taken off. Bent sides count as flat ones that hold all of
// the prism. O(1).
bool overlap(const PrismCorners& a, const PrismCorners& b);

// The prisms that stand, for asking what a new one would pass through (Uehara & Takai 8) [E].
// Cells in levels: each prism lies in up to eight cells at least as large as itself. O(log n) a
// prism while those of a size lie spread out.
class StandingPrisms {
  public:
    // Its parent and those that grow from the same parent don't count: they meet at the joint.
    bool in_the_way(const PrismCorners& corners, std::int32_t parent) const;
    void add(const PrismCorners& corners, std::int32_t parent);

  private:
    struct Box {
        Vec3 low, high;
    };
    struct Cells {
        Vec3 first, count;  // whole numbers
        int level;          // a cell is 2^level mm wide
    };
    struct Standing {
        PrismCorners corners;
        Box box;
        std::int32_t parent;
    };
    static Box box_of(const PrismCorners& corners);
    static Cells cells_of(const Box& box, int level);
    template <class Visit>
    static void visit_cells(const Cells& cells, Visit&& visit);
    static bool meets(const Standing& other, const Standing& prism);

    std::vector<Standing> prisms_;
    std::map<int, std::vector<std::uint32_t>> levels_;           // who lies in each
    std::unordered_map<Key, std::vector<std::uint32_t>> cells_;  // looked up only
};

}  // namespace edaha
