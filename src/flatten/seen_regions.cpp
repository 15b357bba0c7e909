// SPDX-License-Identifier: MIT
#include "flatten/seen_regions.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace edaha {

SeenRegions find_regions(const LabelledMap& labelled) {
    const PlanarMap& map = labelled.map;
    std::vector<std::uint32_t> codes(map.faces());
    for (std::size_t face = 0; face < codes.size(); ++face)
        codes[face] = code_of(labelled.labels[face]);
    SeenRegions regions;
    regions.rings = trace_region_rings(map, codes);
    regions.width.assign(map.next.size(), HUGE_VALF);
    for (const RegionRings::Ring& ring : regions.rings.rings) {
        if (ring.area <= 0) continue;
        double length = 0;
        for (const std::uint32_t h : regions.rings.of(ring))
            length +=
                glm::distance(to_vec(map.nodes[map.origin(h)]), to_vec(map.nodes[map.target(h)]));
        const double width = 2 * ring.area / (length * labelled.steps_per_px);
        for (const std::uint32_t h : regions.rings.of(ring))
            regions.width[h] = static_cast<float>(width);
    }
    return regions;
}

}  // namespace edaha
