// SPDX-License-Identifier: MIT
#include "flatten/arc_graph.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 2000;

ArcGraph::Ends ends_of(const PlanarMap& map, std::span<const std::uint32_t> half_edges) {
    ArcGraph::Ends ends{map.origin(half_edges.front()), map.target(half_edges.back()), 0};
    Vec2 at = to_vec(map.nodes[ends.start]);
    for (const std::uint32_t h : half_edges) {
        const Vec2 next = to_vec(map.nodes[map.target(h)]);
        ends.length += glm::distance(at, next);
        at = next;
    }
    return ends;
}

// Joins nodes over short arcs.
class Contractor {
  public:
    Contractor(ArcGraph& graph, const ContractParams& params)
        : graph_(graph), shortest_(params.shortest), is_outer_(params.is_outer) {}

    void contract() {
        graph_.vanished.assign(graph_.ends.size(), 0);
        std::vector<std::uint32_t> shorts;
        for (std::uint32_t a = 0; a < graph_.ends.size(); ++a) {
            if (graph_.length(a) < shortest_ && !graph_.arcs.arcs[a].closed) shorts.push_back(a);
        }
        std::stable_sort(shorts.begin(), shorts.end(), [&](std::uint32_t a, std::uint32_t b) {
            return graph_.length(a) < graph_.length(b);
        });
        find_clusters(shorts);
        for (const std::uint32_t a : shorts)
            contract(a);
        for (std::uint32_t a = 0; a < graph_.ends.size(); ++a) {
            ArcGraph::Ends& ends = graph_.ends[a];
            ends.start = final_node(ends.start);
            ends.end = final_node(ends.end);
            // Loops where both ends met.
            if (ends.start == ends.end && ends.length < 3 * shortest_ &&
                !graph_.arcs.arcs[a].closed) {
                graph_.vanished[a] = 1;
            }
        }
    }

  private:
    // Nodes that became one, found by union; only ends of short arcs are in clusters.
    struct Cluster {
        std::uint32_t root = 0;
        std::uint32_t node = 0;  // stands for all
        GridBox box;
        double longest = 0;  // of the arcs that end in that node
        bool outer = false;  // lies on the background's border
    };

    std::uint32_t find(std::uint32_t cluster) {
        while (clusters_[cluster].root != cluster)
            cluster = clusters_[cluster].root = clusters_[clusters_[cluster].root].root;
        return cluster;
    }
    std::uint32_t final_node(std::uint32_t node) {
        const std::uint32_t cluster = cluster_of_[node];
        return cluster == kNone ? node : clusters_[find(cluster)].node;
    }

    bool borders_outside(std::uint32_t arc) const {
        const std::uint32_t h = graph_.first_half_edge({arc, true});
        return is_outer_[graph_.map.face_of(h)] || is_outer_[graph_.map.face_of(twin(h))];
    }

    void find_clusters(const std::vector<std::uint32_t>& shorts) {
        cluster_of_.assign(graph_.map.nodes.size(), kNone);
        for (const std::uint32_t a : shorts) {
            for (const std::uint32_t node : {graph_.ends[a].start, graph_.ends[a].end}) {
                if (cluster_of_[node] != kNone) continue;
                cluster_of_[node] = static_cast<std::uint32_t>(clusters_.size());
                Cluster cluster{cluster_of_[node], node, {}, 0, false};
                cluster.box.include(graph_.map.nodes[node]);
                clusters_.push_back(cluster);
            }
        }
        for (std::uint32_t a = 0; a < graph_.ends.size(); ++a) {
            const std::uint32_t start = cluster_of_[graph_.ends[a].start];
            const std::uint32_t end = cluster_of_[graph_.ends[a].end];
            if (start == kNone && end == kNone) continue;
            const bool outer = borders_outside(a);
            for (const std::uint32_t cluster : {start, end}) {
                if (cluster == kNone) continue;
                Cluster& c = clusters_[cluster];
                c.longest = std::max(c.longest, graph_.length(a));
                c.outer = c.outer || outer;
            }
        }
    }

    void contract(std::uint32_t arc) {
        std::uint32_t a = find(cluster_of_[graph_.ends[arc].start]);
        std::uint32_t b = find(cluster_of_[graph_.ends[arc].end]);
        if (clusters_[b].longest > clusters_[a].longest) std::swap(a, b);
        Cluster &kept = clusters_[a], &joined = clusters_[b];
        GridBox box = kept.box;
        box.include(joined.box.min);
        box.include(joined.box.max);
        const GridVector size = box.max - box.min;
        if (double(std::max(size.x, size.y)) > 2 * shortest_) return;
        if (a != b && kept.outer && joined.outer && !borders_outside(arc)) return;
        graph_.vanished[arc] = 1;
        kept.box = box;
        kept.outer = kept.outer || joined.outer;
        joined.root = a;
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
    ArcGraph graph{map, kind_of_edge, cut_arcs(map, kind_of_edge), {}, {}};
    graph.ends.resize(graph.arcs.arcs.size());
    for_each_index(graph.ends.size(), kWorthThreads, [&](std::size_t a) {
        graph.ends[a] = ends_of(map, graph.arcs.of(graph.arcs.arcs[a]));
    });
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
