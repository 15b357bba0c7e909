// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/keyed_random.h"
#include "drawing/drawing.h"
#include "drawing/site.h"
#include "ornament/sprig_params.h"

namespace edaha {

// A place for a sprig, as seen. Millimetres, y down.
struct SprigPlace {
    Site site;           // its direction is the sprig's
    double size_mm = 1;  // of a sprig that is not foreshortened
    double seen = 1;     // of the sprig's length: 0 where it points at the eye or away from it
    double depth = 0;    // towards the eye
};

enum class SprigTone : std::uint32_t { shade, mid, light, back };
inline constexpr std::uint32_t kSprigTones = 4;

// Symbols stand one after the other, variant by variant, tone by tone.
struct SprigSymbols {
    std::uint32_t first = 0;  // index into Drawing::symbols
    std::uint32_t variants = 1;

    std::uint32_t index(SprigTone tone, std::uint32_t variant) const {
        return first + static_cast<std::uint32_t>(tone) * variants + variant;
    }
};

struct SprigLayers {
    Layer behind{"Sprigs behind", {}, {}};
    Layer front{"Sprigs", {}, {}};
    std::size_t count = 0;
};

// Instances of sprigs on their places: a group a clump, the far clumps and in each the far sprigs
// first. They are foreshortened by less than they are seen to be, so that none is a mere line; the
// mirror image of a sprig counts as another. Lit as leaves are. O(n log n). All ours [E].
SprigLayers place_sprigs(std::span<const SprigPlace> places, const SprigSymbols& symbols,
                         const SprigParams& params,
                         const std::function<std::string(std::int32_t)>& clump_id,
                         const KeyedRandom& random);

}  // namespace edaha
