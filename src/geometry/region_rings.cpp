// SPDX-License-Identifier: MIT
#include "geometry/region_rings.h"

#include <cassert>

namespace edaha {
namespace {

class RingTracer {
  public:
    RingTracer(const PlanarMap& map, std::span<const std::uint32_t> labels)
        : map_(map), labels_(labels), done_(map.next.size(), 0), place_(map.nodes.size(), kNone) {}

    RegionRings trace() {
        for (std::uint32_t h = 0; h < map_.next.size(); ++h) {
            if (!done_[h] && is_border(h)) follow(h);
        }
        return std::move(result_);
    }

  private:
    std::uint32_t label(std::uint32_t h) const { return labels_[map_.face_of(h)]; }
    bool is_border(std::uint32_t h) const { return label(h) != 0 && label(h) != label(twin(h)); }

    // The next border half-edge round the same sector of the region.
    std::uint32_t next_border(std::uint32_t h) const {
        h = map_.next[h];
        while (!is_border(h))
            h = map_.next[twin(h)];
        return h;
    }

    // Walks once round; where the walk comes back to a node, what lies between is a ring.
    void follow(std::uint32_t start) {
        std::uint32_t h = start;
        do {
            done_[h] = 1;
            const std::uint32_t node = map_.origin(h);
            if (place_[node] != kNone) cut(place_[node]);
            place_[node] = static_cast<std::uint32_t>(walk_.size());
            walk_.push_back(h);
            h = next_border(h);
        } while (h != start);
        cut(0);
    }

    void cut(std::uint32_t from) {
        RegionRings::Ring ring;
        ring.label = label(walk_[from]);
        ring.first = static_cast<std::uint32_t>(result_.half_edges.size());
        const GridPoint anchor = map_.nodes[map_.origin(walk_[from])];
        Int128 twice_area = 0;
        for (std::size_t i = from; i < walk_.size(); ++i) {
            const std::uint32_t h = walk_[i];
            place_[map_.origin(h)] = kNone;
            result_.half_edges.push_back(h);
            twice_area +=
                cross(map_.nodes[map_.origin(h)] - anchor, map_.nodes[map_.target(h)] - anchor);
        }
        walk_.resize(from);
        ring.end = static_cast<std::uint32_t>(result_.half_edges.size());
        ring.area = static_cast<double>(twice_area) * 0.5;
        result_.rings.push_back(ring);
    }

    const PlanarMap& map_;
    std::span<const std::uint32_t> labels_;
    std::vector<std::uint8_t> done_;
    std::vector<std::uint32_t> place_;  // a node's place in the walk
    std::vector<std::uint32_t> walk_;
    RegionRings result_;
};

}  // namespace

RegionRings trace_region_rings(const PlanarMap& map, std::span<const std::uint32_t> labels) {
    assert(labels.size() == map.faces());
    return RingTracer(map, labels).trace();
}

}  // namespace edaha
