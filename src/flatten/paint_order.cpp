// SPDX-License-Identifier: MIT
#include "flatten/paint_order.h"

#include <algorithm>
#include <array>

namespace edaha {
namespace {

struct Seen {
    double area = 0, depth = 0;  // depth times area
    std::array<double, 8> of_tone{};
};

std::vector<Seen> measure(const LabelledMap& map, std::size_t parts) {
    std::vector<Seen> seen(parts);
    for (const PlanarMap::Loop& loop : map.map.loops) {
        const FaceLabel label = map.labels[loop.face];
        if (label.part == kNone) continue;
        Seen& part = seen[label.part];
        part.area += loop.area;
        part.depth += loop.area * map.depth[loop.face];
        part.of_tone[std::min<std::size_t>(label.tone, 7)] += loop.area;
    }
    return seen;
}

std::uint8_t base_tone(const Seen& part, int bands) {
    const auto middle = static_cast<std::uint8_t>(std::clamp((bands - 1) / 2, 0, 7));
    if (part.of_tone[middle] > 0) return middle;
    const auto most = std::max_element(part.of_tone.begin(), part.of_tone.end());
    return static_cast<std::uint8_t>(most - part.of_tone.begin());
}

}  // namespace

PaintOrder paint_order(const LabelledMap& map, std::size_t parts, int bands) {
    const std::vector<Seen> seen = measure(map, parts);
    struct Place {
        double depth;
        std::uint32_t part;
    };
    std::vector<Place> places;
    for (std::uint32_t p = 0; p < parts; ++p) {
        if (seen[p].area > 0) places.push_back({seen[p].depth / seen[p].area, p});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
        return a.depth != b.depth ? a.depth > b.depth : a.part < b.part;
    });
    PaintOrder order;
    order.rank.assign(parts, 0);
    if (places.empty()) return order;
    const double far = places.front().depth, near = places.back().depth;
    for (const Place& place : places) {
        const double nearness = far > near ? (far - place.depth) / (far - near) : 1;
        order.parts.push_back({place.part, base_tone(seen[place.part], bands), nearness});
        order.rank[place.part] = static_cast<std::uint32_t>(order.parts.size());
    }
    return order;
}

}  // namespace edaha
