// SPDX-License-Identifier: MIT
#include "geometry/arcs.h"

#include <cassert>

namespace edaha {
namespace {

class ArcCutter {
  public:
    ArcCutter(const PlanarMap& map, std::span<const std::uint32_t> kind) : map_(map), kind_(kind) {
        result_.use_of.resize(map.next.size());
        degree_.assign(map.nodes.size(), 0);
        for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
            if (kind[e] == 0) continue;
            ++degree_[map.edges[e].from];
            ++degree_[map.edges[e].to];
        }
    }

    ArcSet cut() {
        const auto count = static_cast<std::uint32_t>(map_.next.size());
        for (std::uint32_t h = 0; h < count; ++h) {
            if (is_free(h) && ends_before(h)) follow(h);
        }
        for (std::uint32_t h = 0; h < count; ++h) {  // what is left are closed chains
            if (is_free(h)) follow(h);
        }
        return std::move(result_);
    }

  private:
    bool is_free(std::uint32_t h) const {
        return kind_[h / 2] != 0 && result_.use_of[h].arc == kNone;
    }

    // The kept half-edge after h round its target: its own twin if there is no other.
    std::uint32_t next_kept(std::uint32_t h) const {
        h = map_.next[h];
        while (kind_[h / 2] == 0)
            h = map_.next[twin(h)];
        return h;
    }

    bool ends_after(std::uint32_t h) const {
        return degree_[map_.target(h)] != 2 || kind_[next_kept(h) / 2] != kind_[h / 2];
    }
    bool ends_before(std::uint32_t h) const { return ends_after(twin(h)); }

    void follow(std::uint32_t start) {
        const auto id = static_cast<std::uint32_t>(result_.arcs.size());
        Arc arc;
        arc.first = static_cast<std::uint32_t>(result_.half_edges.size());
        std::uint32_t h = start;
        while (true) {
            result_.half_edges.push_back(h);
            result_.use_of[h] = {id, true};
            result_.use_of[twin(h)] = {id, false};
            if (ends_after(h)) break;
            h = next_kept(h);
            arc.closed = h == start;
            if (arc.closed) break;
        }
        arc.end = static_cast<std::uint32_t>(result_.half_edges.size());
        result_.arcs.push_back(arc);
    }

    const PlanarMap& map_;
    std::span<const std::uint32_t> kind_;
    std::vector<std::uint32_t> degree_;
    ArcSet result_;
};

}  // namespace

ArcSet cut_arcs(const PlanarMap& map, std::span<const std::uint32_t> kind_of_edge) {
    assert(kind_of_edge.size() == map.edges.size());
    return ArcCutter(map, kind_of_edge).cut();
}

std::vector<ArcUse> arcs_of_ring(const ArcSet& set, std::span<const std::uint32_t> ring) {
    std::vector<ArcUse> uses;
    for (const std::uint32_t h : ring) {
        const ArcUse use = set.use_of[h];
        const Arc& arc = set.arcs[use.arc];
        const std::uint32_t entry =
            use.forward ? set.half_edges[arc.first] : twin(set.half_edges[arc.end - 1]);
        // A ring may start in the middle of a closed arc, which then makes up all of it.
        if (h == entry) uses.push_back(use);
    }
    return uses;
}

}  // namespace edaha
