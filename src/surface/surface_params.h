// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace edaha {

struct Mesh;

// A burl sphere that a user places (section 6): its centre is the cambium vertex nearest to a point
// of the trunk's surface at the step `from`, and moves with it.
struct BurlPlace {
    double height_mm = 1000;
    double azimuth_rad = 0;  // 0: towards the eye at azimuth 0
    double radius_mm = 300;  // R
    double core_mm = 160;    // R'
    double strength = 0.5;   // k
    std::int64_t from = 1;   // step
};

enum class SolidShape { plane, box, ball, rod, wire, mesh };

// A solid, as an obstacle (section 8) or as the region of a hollow (section 7). A plane is solid
// below it, square to `to - from`; a box has those as opposite corners; a ball its middle at
// `from`; a rod is round, with round ends, from `from` to `to`; a wire is a rod in zigzag; a mesh
// has its origin at `from`.
struct SolidParams {
    SolidShape shape = SolidShape::rod;
    glm::dvec3 from{0}, to{0, 1000, 0};
    double radius_mm = 40;
    std::int64_t step = 1;             // from which on it is there
    std::string file;                  // of a mesh: OBJ or PLY
    std::shared_ptr<const Mesh> mesh;  // what that holds, closed; nothing is there without
};

// What a tree grows by whose surface grows, after Mizoguchi & Miyata 2014 [P]; the rest is ours
// [E]. Lengths in mm of the tree.
struct SurfaceParams {
    std::int64_t steps = 300;     // n_end
    double split_mm = 150;        // T_s: longer edges are split (4.3)
    double merge_mm = 70;         // T_m: shorter edges go if they shrink (eq. 2)
    bool flips = true;            // edges turn towards better angles [E]
    double smoothing = 0.2;       // vertices slide towards their neighbours' middle [E]
    std::int64_t sides = 8;       // of the seed's prism, and phloem lines (4.1)
    double seed_radius_mm = 120;  //
    double seed_height_mm = 200;  //
    double speed_mm = 60;         // S_a of the first apex (eq. 3)
    double thickening_mm = 3;     // S_c (eq. 4)
    double winding_rad = 0;       // theta_p, a mm of travel (eq. 7)
    std::string rules;            // the L-system: see rules.h
    // Burls by uneven nutrients: spheres strung along a phloem line (6.3).
    std::int64_t strung = 0;      // m
    double burl_radius_mm = 300;  // R
    double burl_core_mm = 160;    // R'
    double burl_strength = 1;     // k
    // Burls by insects and bacteria, at random (6.2).
    std::int64_t random_burls = 0;
    double decay_mm = 6;             // S_h (eq. 8)
    double closing = 0;              // A (eq. 9)
    bool rim = false;                // a burl sphere at each cambium vertex beside xylem (7.2)
    double rim_radius_mm = 250;      // R of those
    double rim_strength = 0.3;       // k of those
    double wrapping = 1;             // B (eq. 10)
    double contact_radius_mm = 300;  // R of the burl sphere at each contact (8)
    double contact_strength = 3;     // k of those
    double sprig_mm = 300;           // size of the places for twigs [E]
    double sprig_spacing_mm = 200;   // [E]
    double sprig_reach_mm = 1500;    // of places for twigs from their apex [E]
    bool deadwood = false;           // branches that the rules stop are bare and grey [E]
    std::int64_t face_limit = 2'000'000;
    std::vector<BurlPlace> burls;
    std::vector<SolidParams> hollows;
    std::vector<SolidParams> obstacles;
};

}  // namespace edaha
