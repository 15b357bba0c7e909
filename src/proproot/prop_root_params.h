// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

namespace edaha {

enum class RootType { standard, gentle, steep };
enum class RootHeights { uniform, geometric };

// Prop roots of Rhizophora stylosa after Sato, "Automatic generation of prop roots" (2009) [P];
// the rest is ours [E]. Lengths in the thesis' unit, about 1 cm. What is "by the table" follows
// from the number of primary roots, which stands for the plant's age (root_tables.h).
struct PropRootParams {
    int primaries = 20;  // roots that leave the trunk: 1-100 (3.3.3)
    RootType type = RootType::standard;
    int max_order = 0;        // 1-5; 0: by table 3.3
    double branchings = -1;   // forks of a root of typical length; -1: by table 3.4
    int max_branchings = -1;  // most of one root; -1: by table 3.4
    double bulges = -1;       // share that rises at first; -1: by the type (table 3.2)
    double highest = 0;       // height of the highest primary; 0: by table 3.1
    RootHeights heights = RootHeights::uniform;  // geometric: dense below, sparse above [E]
    // Weights of |angle| from its parent at which a root sets out, seen from above, in nine bins
    // of 20 degrees; the last one ends at 170 [E, for the thesis' fig. 3.9].
    std::vector<double> turn_weights{30, 22, 15, 11, 8, 6, 4, 3, 1};
    bool apart = true;        // no root passes through another one [E]
    int tries = 24;           // how often one that would is drawn anew before it is left out [E]
    double young = 0.05;      // share that has not reached the ground [E]
    double knob = 0.4;        // swelling where a primary leaves the trunk, part of its radius [E]
    double trunk_bend = 0.5;  // of a trunk with 100 primaries: 1 leans by a fifth of its height [E]
    double trunk_taper = 0.4;  // the same trunk's loss of radius over its height [E]
    // The seedling: a larger propagule, and one planted deeper, strikes more roots. The number of
    // primaries is multiplied by (length / 30) (1 + 0.6 (depth - 0.5)) [E].
    double propagule_length = 30;  // cm: 15-60
    double planting_depth = 0.5;   // buried part of it: 0-1
    int circle_points = 12;        // of a tube's circle (3.3.1)
    int curve_points = 16;         // circles along a root, for a right angle's bend (3.3.1)
    bool order_colours = false;    // red, orange, yellow, cream, white by order (fig. 4.1)
};

}  // namespace edaha
