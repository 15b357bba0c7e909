// SPDX-License-Identifier: MIT
#include "geometry/planar_map.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "geometry/nest_loops.h"

namespace edaha {
namespace {

// Half-edges by the angle at which they leave their node, from +x towards +y. `half_turn` is 0 or
// 1; within half a turn the cross product orders them.
struct Spoke {
    GridVector direction;
    std::uint32_t half_edge = 0;
    bool half_turn = false;
};

bool before(const Spoke& a, const Spoke& b) {
    if (a.half_turn != b.half_turn) return b.half_turn;
    return cross(a.direction, b.direction) > 0;
}

Spoke spoke_of(const PlanarMap& map, std::uint32_t half_edge) {
    const GridVector d = map.nodes[map.target(half_edge)] - map.nodes[map.origin(half_edge)];
    return {d, half_edge, d.y < 0 || (d.y == 0 && d.x < 0)};
}

// Whoever arrives by the twin of a spoke goes on by the spoke before it.
void link_spokes(PlanarMap& map, std::vector<Spoke>& spokes) {
    std::sort(spokes.begin(), spokes.end(), before);
    for (std::size_t i = 0; i < spokes.size(); ++i) {
        const std::size_t previous = i == 0 ? spokes.size() - 1 : i - 1;
        map.next[twin(spokes[i].half_edge)] = spokes[previous].half_edge;
    }
}

void link_half_edges(PlanarMap& map) {
    const auto count = static_cast<std::uint32_t>(map.edges.size() * 2);
    std::vector<std::uint32_t> first(map.nodes.size() + 2, 0);
    for (std::uint32_t h = 0; h < count; ++h)
        ++first[map.origin(h) + 2];
    for (std::size_t i = 1; i < first.size(); ++i)
        first[i] += first[i - 1];
    std::vector<std::uint32_t> leaving(count);
    for (std::uint32_t h = 0; h < count; ++h)
        leaving[first[map.origin(h) + 1]++] = h;
    map.next.resize(count);
    constexpr std::size_t kChunk = 4096;
    for_each_index((map.nodes.size() + kChunk - 1) / kChunk, 4, [&](std::size_t chunk) {
        std::vector<Spoke> spokes;
        const std::size_t end = std::min(map.nodes.size(), (chunk + 1) * kChunk);
        for (std::size_t node = chunk * kChunk; node < end; ++node) {
            spokes.clear();
            for (std::uint32_t i = first[node]; i < first[node + 1]; ++i)
                spokes.push_back(spoke_of(map, leaving[i]));
            link_spokes(map, spokes);
        }
    });
}

PlanarMap::Loop trace_loop(PlanarMap& map, std::uint32_t start) {
    const auto id = static_cast<std::uint32_t>(map.loops.size());
    const GridPoint anchor = map.nodes[map.origin(start)];
    PlanarMap::Loop loop;
    loop.first = start;
    Int128 twice_area = 0;
    std::uint32_t h = start;
    do {
        map.loop_of[h] = id;
        if (map.origin(h) < map.origin(loop.first)) loop.first = h;
        twice_area += cross(map.nodes[map.origin(h)] - anchor, map.nodes[map.target(h)] - anchor);
        h = map.next[h];
    } while (h != start);
    loop.area = static_cast<double>(twice_area) * 0.5;
    return loop;
}

void trace_loops(PlanarMap& map) {
    map.loop_of.assign(map.next.size(), kNone);
    for (std::uint32_t h = 0; h < map.next.size(); ++h) {
        if (map.loop_of[h] == kNone) map.loops.push_back(trace_loop(map, h));
    }
}

// Faces in the order of their outer loops. Hole loops take the face of the loop below them, which
// belongs to a component with a smaller first node and is settled before.
void assign_faces(PlanarMap& map) {
    std::vector<std::uint32_t> holes;
    std::uint32_t faces = 1;
    for (std::uint32_t i = 0; i < map.loops.size(); ++i) {
        if (map.loops[i].area > 0) {
            map.loops[i].face = faces++;
        } else {
            holes.push_back(i);
        }
    }
    std::sort(holes.begin(), holes.end(), [&](std::uint32_t a, std::uint32_t b) {
        return map.origin(map.loops[a].first) < map.origin(map.loops[b].first);
    });
    const std::vector<std::uint32_t> below = loops_below(map, holes);
    for (std::size_t i = 0; i < holes.size(); ++i) {
        map.loops[holes[i]].face = below[i] == kNone ? 0 : map.loops[below[i]].face;
    }
    map.first_loop.assign(faces + 2, 0);
    for (const PlanarMap::Loop& loop : map.loops)
        ++map.first_loop[loop.face + 2];
    for (std::size_t i = 1; i < map.first_loop.size(); ++i) {
        map.first_loop[i] += map.first_loop[i - 1];
    }
    map.face_loops.resize(map.loops.size());
    for (const bool outer : {true, false}) {
        for (std::uint32_t i = 0; i < map.loops.size(); ++i) {
            if ((map.loops[i].area > 0) != outer) continue;
            map.face_loops[map.first_loop[map.loops[i].face + 1]++] = i;
        }
    }
    map.first_loop.pop_back();
}

template <typename Visit>
void visit_border(const PlanarMap& map, std::uint32_t face, Visit&& visit) {
    for (const std::uint32_t loop : map.loops_of(face)) {
        std::uint32_t h = map.loops[loop].first;
        do {
            visit(h);
            h = map.next[h];
        } while (h != map.loops[loop].first);
    }
}

}  // namespace

PlanarMap build_planar_map(std::vector<GridPoint> nodes, std::vector<Edge> edges) {
    PlanarMap map;
    map.nodes = std::move(nodes);
    map.edges = std::move(edges);
    link_half_edges(map);
    trace_loops(map);
    assign_faces(map);
    return map;
}

double face_area(const PlanarMap& map, std::uint32_t face) {
    if (face == 0) return 0;
    double area = 0;
    for (const std::uint32_t loop : map.loops_of(face))
        area += map.loops[loop].area;
    return area;
}

Vec2 interior_point(const PlanarMap& map, std::uint32_t face) {
    GridBox box;
    visit_border(map, face, [&](std::uint32_t h) { box.include(map.nodes[map.origin(h)]); });
    const double y = (box.min.y + box.max.y - 1) / 2 + 0.5;  // NOLINT: between two rows
    std::vector<double> crossings;
    visit_border(map, face, [&](std::uint32_t h) {
        const Vec2 a = to_vec(map.nodes[map.origin(h)]), b = to_vec(map.nodes[map.target(h)]);
        if ((a.y < y) != (b.y < y)) {
            crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
        }
    });
    std::sort(crossings.begin(), crossings.end());
    double widest = -1, x = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const double width = crossings[i + 1] - crossings[i];
        if (width > widest) widest = width, x = (crossings[i] + crossings[i + 1]) * 0.5;
    }
    return {x, y};
}

}  // namespace edaha
