// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <vector>

#include "geometry/planar_map.h"
#include "geometry/snap_round.h"
#include "shapes.h"

namespace edaha::oracles {

// Slow and simple judges of arrangements and maps.

inline std::vector<GridSegment> random_soup(int count, int side, std::uint64_t seed) {
    shapes::Random random{seed};
    const auto point = [&] {
        const auto at = [&] { return static_cast<std::int32_t>(random() * side) - side / 2; };
        const std::int32_t x = at();
        return GridPoint{x, at()};
    };
    std::vector<GridSegment> soup;
    for (int i = 0; i < count; ++i) {
        const GridPoint a = point();
        soup.push_back({a, point()});
    }
    return soup;
}

inline bool strictly_inside(const GridSegment& s, GridPoint p) {
    return p != s.a && p != s.b && orientation(s.a, s.b, p) == 0 && dot(p - s.a, p - s.b) < 0;
}

inline bool cross(const GridSegment& s, const GridSegment& t) {
    const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
    return sign(orientation(s.a, s.b, t.a)) * sign(orientation(s.a, s.b, t.b)) < 0 &&
           sign(orientation(t.a, t.b, s.a)) * sign(orientation(t.a, t.b, s.b)) < 0;
}

// All pairs: no two edges cross, none has an end of another inside it, none is there twice.
inline bool touch_only_in_nodes(const Arrangement& arrangement) {
    std::vector<GridSegment> edges;
    for (const Edge& e : arrangement.edges) {
        edges.push_back({arrangement.nodes[e.from], arrangement.nodes[e.to]});
        if (e.from >= e.to) return false;
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = 0; j < edges.size(); ++j) {
            if (i == j) continue;
            if (edges[i].a == edges[j].a && edges[i].b == edges[j].b) return false;
            if (cross(edges[i], edges[j]) || strictly_inside(edges[i], edges[j].a) ||
                strictly_inside(edges[i], edges[j].b)) {
                return false;
            }
        }
    }
    return true;
}

// Connected components of the nodes that have edges, by flooding.
inline std::size_t components(const PlanarMap& map) {
    std::vector<std::vector<std::uint32_t>> neighbours(map.nodes.size());
    for (const Edge& e : map.edges) {
        neighbours[e.from].push_back(e.to);
        neighbours[e.to].push_back(e.from);
    }
    std::vector<bool> seen(map.nodes.size(), false);
    std::size_t count = 0;
    for (std::uint32_t start = 0; start < map.nodes.size(); ++start) {
        if (seen[start] || neighbours[start].empty()) continue;
        ++count;
        std::vector<std::uint32_t> stack{start};
        seen[start] = true;
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            for (const std::uint32_t next : neighbours[node]) {
                if (!seen[next]) stack.push_back(next), seen[next] = true;
            }
        }
    }
    return count;
}

inline std::size_t nodes_in_use(const PlanarMap& map) {
    std::vector<std::uint32_t> used;
    for (const Edge& e : map.edges)
        used.push_back(e.from), used.push_back(e.to);
    std::sort(used.begin(), used.end());
    return static_cast<std::size_t>(std::unique(used.begin(), used.end()) - used.begin());
}

// The face around a point, by the nearest edge below it on its vertical line; the point's x must
// not be an integer. 0 if there is none.
inline std::uint32_t face_at(const PlanarMap& map, Vec2 p) {
    double nearest = -1e300;
    std::uint32_t face = 0;
    for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
        const Vec2 a = to_vec(map.nodes[map.edges[e].from]);
        const Vec2 b = to_vec(map.nodes[map.edges[e].to]);
        if ((a.x < p.x) == (b.x < p.x)) continue;
        const double y = a.y + (b.y - a.y) * ((p.x - a.x) / (b.x - a.x));
        if (y < p.y && y > nearest) nearest = y, face = map.face_of(2 * e);
    }
    return face;
}

inline PlanarMap map_of(const std::vector<GridSegment>& segments) {
    Arrangement arrangement = snap_round(segments);
    return build_planar_map(std::move(arrangement.nodes), std::move(arrangement.edges));
}

}  // namespace edaha::oracles
