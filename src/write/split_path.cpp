// SPDX-License-Identifier: MIT
#include "write/split_path.h"

#include <algorithm>
#include <optional>

#include "drawing/subpaths.h"
#include "geometry/bounds.h"
#include "geometry/measure.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

struct Ring {
    Path path;
    Bounds box;
    double area = 0;
    std::size_t nodes = 0;
    std::size_t owner = 0;  // the outline a hole is cut from; an outline's is itself
};

// A hole's nodes lie in its outline or touch it: this is fine enough to tell which.
constexpr double kOutlineTolerance_mm = 0.01;

// How often the closed ring winds round p, by the crossings of a ray to the right.
int winding(const Path& ring, Vec2 p) {
    int turns = 0;
    walk_path(ring, [&](const PathSegment& segment) {
        const auto points = segment.verb == Verb::cubic
                                ? flatten(segment.curve, kOutlineTolerance_mm)
                                : std::vector<Vec2>{segment.curve.p0, segment.curve.p3};
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2 a = points[i - 1], b = points[i];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            if (b.y > a.y ? side > 0 : side < 0) turns += b.y > a.y ? 1 : -1;
        }
    });
    return turns;
}

// Most of the hole's nodes are inside: some may touch the outline.
bool lies_in(const Path& hole, const Path& outline) {
    std::size_t inside = 0, asked = 0;
    walk_path(hole, [&](const PathSegment& segment) {
        inside += winding(outline, segment.curve.p0) != 0;
        ++asked;
    });
    return 2 * inside > asked;
}

bool box_in(const Bounds& inner, const Bounds& outer) {
    return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.max.x <= outer.max.x &&
           inner.max.y <= outer.max.y;
}

std::vector<Ring> rings_of(const Path& path) {
    std::vector<Ring> rings;
    for (Path& part : subpaths(path)) {
        Ring ring{std::move(part), {}, 0, 0, rings.size()};
        ring.box = bounds(ring.path);
        ring.area = signed_area(ring.path);
        ring.nodes = node_count(ring.path);
        rings.push_back(std::move(ring));
    }
    return rings;
}

void find_owners(std::vector<Ring>& rings) {
    std::vector<std::size_t> outlines;  // smallest first
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (rings[i].area >= 0) outlines.push_back(i);
    }
    std::stable_sort(outlines.begin(), outlines.end(),
                     [&](std::size_t a, std::size_t b) { return rings[a].area < rings[b].area; });
    for (Ring& hole : rings) {
        if (hole.area >= 0) continue;
        const auto found = std::find_if(outlines.begin(), outlines.end(), [&](std::size_t i) {
            return rings[i].area >= -hole.area && box_in(hole.box, rings[i].box) &&
                   lies_in(hole.path, rings[i].path);
        });
        if (found != outlines.end()) hole.owner = *found;
    }
}

void append(Path& path, const Path& part) {
    path.verbs.insert(path.verbs.end(), part.verbs.begin(), part.verbs.end());
    path.points.insert(path.points.end(), part.points.begin(), part.points.end());
}

}  // namespace

std::vector<Path> split_path(const Path& path, std::size_t most_nodes) {
    std::vector<Ring> rings = rings_of(path);
    find_owners(rings);
    std::vector<std::size_t> family_nodes(rings.size(), 0);
    for (const Ring& ring : rings)
        family_nodes[ring.owner] += ring.nodes;

    // Families go in the order of their outlines into the last path while it has room.
    std::vector<std::size_t> path_of(rings.size(), 0);
    std::vector<Path> paths;
    std::size_t used = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (rings[i].owner != i) continue;
        if (paths.empty() || used + family_nodes[i] > most_nodes) {
            paths.emplace_back();
            used = 0;
        }
        used += family_nodes[i];
        path_of[i] = paths.size() - 1;
    }
    for (const Ring& ring : rings)
        append(paths[path_of[ring.owner]], ring.path);
    return paths;
}

}  // namespace edaha
