// SPDX-License-Identifier: MIT
#include "flatten/arc_graph.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

double arc_length_of(const PlanarMap& map, std::span<const std::uint32_t> half_edges) {
    double sum = 0;
    for (const std::uint32_t h : half_edges)
        sum += glm::distance(to_vec(map.nodes[map.origin(h)]), to_vec(map.nodes[map.target(h)]));
    return sum;
}

// Joins nodes over short arcs.
class Contractor {
  public:
    Contractor(ArcGraph& graph, const ContractParams& params)
        : graph_(graph), shortest_(params.shortest), is_outer_(params.is_outer) {}

    void contract() {
        std::vector<std::uint32_t>& root = graph_.node_of;
        root.resize(graph_.map.nodes.size());
        std::iota(root.begin(), root.end(), 0U);
        graph_.vanished.assign(graph_.arcs.arcs.size(), 0);
        std::vector<std::uint32_t> shorts;
        for (std::uint32_t a = 0; a < graph_.length.size(); ++a) {
            if (graph_.length[a] < shortest_ && !graph_.arcs.arcs[a].closed) shorts.push_back(a);
        }
        std::stable_sort(shorts.begin(), shorts.end(), [&](std::uint32_t a, std::uint32_t b) {
            return graph_.length[a] < graph_.length[b];
        });
        measure(shorts);
        for (const std::uint32_t a : shorts)
            contract(a);
        for (std::uint32_t node = 0; node < root.size(); ++node)
            root[node] = find(node);
        for (std::uint32_t a = 0; a < graph_.length.size(); ++a) {  // loops where both ends met
            if (graph_.length[a] < 3 * shortest_ && !graph_.arcs.arcs[a].closed &&
                graph_.start_node({a, true}) == graph_.end_node({a, true})) {
                graph_.vanished[a] = 1;
            }
        }
    }

  private:
    struct Cluster {
        GridBox box;
        double longest = 0;  // of the arcs that end in the node that stands for it
        bool outer = false;  // lies on the background's border
    };

    std::uint32_t find(std::uint32_t node) {
        std::vector<std::uint32_t>& root = graph_.node_of;
        while (root[node] != node)
            node = root[node] = root[root[node]];
        return node;
    }

    bool borders_outside(std::uint32_t arc) const {
        const std::uint32_t h = graph_.first_half_edge({arc, true});
        return is_outer_[graph_.map.face_of(h)] || is_outer_[graph_.map.face_of(twin(h))];
    }

    // Only nodes of short arcs have clusters.
    void measure(const std::vector<std::uint32_t>& shorts) {
        cluster_of_.assign(graph_.map.nodes.size(), kNone);
        for (const std::uint32_t a : shorts) {
            for (const bool forward : {true, false}) {
                const std::uint32_t node = graph_.start_node({a, forward});
                if (cluster_of_[node] != kNone) continue;
                cluster_of_[node] = static_cast<std::uint32_t>(clusters_.size());
                Cluster cluster;
                cluster.box.include(graph_.map.nodes[node]);
                clusters_.push_back(cluster);
            }
        }
        for (std::uint32_t a = 0; a < graph_.length.size(); ++a) {
            for (const bool forward : {true, false}) {
                const std::uint32_t cluster = cluster_of_[graph_.start_node({a, forward})];
                if (cluster == kNone) continue;
                clusters_[cluster].longest = std::max(clusters_[cluster].longest, graph_.length[a]);
                clusters_[cluster].outer |= borders_outside(a);
            }
        }
    }

    void contract(std::uint32_t arc) {
        std::uint32_t a = find(graph_.start_node({arc, true}));
        std::uint32_t b = find(graph_.start_node({arc, false}));
        Cluster &first = clusters_[cluster_of_[a]], &second = clusters_[cluster_of_[b]];
        GridBox box = first.box;
        box.include(second.box.min);
        box.include(second.box.max);
        const GridVector size = box.max - box.min;
        if (double(std::max(size.x, size.y)) > 2 * shortest_) return;
        if (a != b && first.outer && second.outer && !borders_outside(arc)) return;
        graph_.vanished[arc] = 1;
        if (a == b) return;
        if (second.longest > first.longest) std::swap(a, b);
        Cluster& kept = clusters_[cluster_of_[a]];
        kept.box = box;
        kept.outer = first.outer || second.outer;
        graph_.node_of[b] = a;
    }

    ArcGraph& graph_;
    double shortest_;
    std::span<const std::uint8_t> is_outer_;
    std::vector<std::uint32_t> cluster_of_;  // a node
    std::vector<Cluster> clusters_;
};

Vec2 leaving_direction(const ArcGraph& graph, ArcUse use, double window) {
    const PlanarMap& map = graph.map;
    const GridPoint node = map.nodes[map.origin(graph.first_half_edge(use))];
    Vec2 direction(0);
    for (std::size_t i = 0; i < graph.size(use.arc); ++i) {
        const GridVector way = map.nodes[map.target(graph.half_edge(use, i))] - node;
        if (way.x == 0 && way.y == 0) break;
        direction = {double(way.x), double(way.y)};
        if (glm::dot(direction, direction) >= window * window) break;
    }
    return glm::normalize(direction);
}

}  // namespace

ArcGraph make_arc_graph(const PlanarMap& map, std::span<const std::uint32_t> kind_of_edge,
                        const ContractParams& params) {
    ArcGraph graph{map, kind_of_edge, cut_arcs(map, kind_of_edge), {}, {}, {}};
    for (const Arc& arc : graph.arcs.arcs)
        graph.length.push_back(arc_length_of(map, graph.arcs.of(arc)));
    Contractor(graph, params).contract();
    return graph;
}

std::vector<Spoke> spokes_of(const ArcGraph& graph, std::span<const std::uint8_t> wanted,
                             double window) {
    std::vector<Spoke> spokes;
    for (std::uint32_t a = 0; a < graph.arcs.arcs.size(); ++a) {
        if (graph.arcs.arcs[a].closed || graph.vanished[a] || !wanted[a]) continue;
        for (const bool forward : {true, false}) {
            const ArcUse use{a, forward};
            spokes.push_back({graph.start_node(use), 2 * a + (forward ? 0 : 1),
                              leaving_direction(graph, use, window), graph.kind(a)});
        }
    }
    std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
        return a.node != b.node ? a.node < b.node : a.end < b.end;
    });
    return spokes;
}

}  // namespace edaha
