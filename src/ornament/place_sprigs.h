// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/colour.h"
#include "base/keyed_random.h"
#include "drawing/drawing.h"
#include "ornament/sprig_params.h"

namespace edaha {

// A place for a sprig, as seen: x to the right, y down, z towards the eye, from the middle of the
// picture's depth.
struct SprigPlace {
    Key key = 0;
    glm::dvec3 foot{0};              // mm
    glm::dvec3 direction{0, -1, 0};  // unit
    double size_mm = 1;              // of a sprig that is not foreshortened
};

// A sprig is three symbols, one upon the other.
enum class SprigPart : std::uint32_t { stem, inner, outer };
inline constexpr std::uint32_t kSprigParts = 3;

// Symbols stand one after the other, variant by variant, part by part.
struct SprigSymbols {
    std::uint32_t first = 0;  // index into Drawing::symbols
    std::uint32_t variants = 1;

    std::uint32_t index(SprigPart part, std::uint32_t variant) const {
        return first + variant * kSprigParts + static_cast<std::uint32_t>(part);
    }
};

// In the order in which those of one clump are painted.
enum class SprigTone : std::uint32_t { far_shade, far, shade, mid, light };
inline constexpr std::uint32_t kSprigTones = 5;

struct SprigInks {
    struct Leaves {
        Colour inner, outer;
    };
    Colour stem, far_stem;
    std::array<Leaves, kSprigTones> leaves;  // a tone
    bool stroked = false;                    // leaves have strokes that take the tone's colour, too
};

struct SprigLayers {
    Layer behind{"Sprigs behind", {}, {}};
    Layer front{"Sprigs", {}, {}};
    std::size_t count = 0;
};

// Instances of sprigs on their places: leaves of those that leave the wood on its far side, and all
// stems, on the layer behind the wood. So each stem comes out from behind the wood that its foot
// stands on. Leaves are a group a clump (sprig_clumps.h), the far and high ones first, and in it a
// group a tone. Sprigs turn outwards from their clump's middle and are smaller at its rim, so that
// it is a rounded mass; `to_light` shines on that mass and on the whole crown. They
// are foreshortened by less than they are seen to be, so that none is a mere line; the
// mirror image of a sprig counts as another. O(n clumps). All ours [E].
SprigLayers place_sprigs(std::span<const SprigPlace> places, const SprigSymbols& symbols,
                         const SprigParams& params, const SprigInks& inks,
                         const glm::dvec3& to_light, const KeyedRandom& random);

}  // namespace edaha
