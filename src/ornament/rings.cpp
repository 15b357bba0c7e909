// SPDX-License-Identifier: MIT
#include "ornament/rings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "drawing/subpaths.h"
#include "geometry/bounds.h"
#include "geometry/measure.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

// Enough for 700 curves in the usual scatter; ten thousand such shapes still take seconds.
constexpr std::size_t kMostPairs = 1'000'000;

bool is_close(Vec2 a, Vec2 b, double distance) {
    return std::abs(a.x - b.x) <= distance && std::abs(a.y - b.y) <= distance;
}

bool has_length(const PathSegment& segment, double shortest) {
    const Cubic& c = segment.curve;
    return !is_close(c.p0, c.p3, shortest) ||
           (segment.verb == Verb::cubic &&
            !(is_close(c.p0, c.p1, shortest) && is_close(c.p0, c.p2, shortest)));
}

// One subpath; empty if nothing is left of it.
Path tidy_subpath(const Path& part, double shortest) {
    Path tidy;
    Vec2 at(0);
    walk_path(part, [&](const PathSegment& segment) {
        const Cubic& c = segment.curve;
        if (segment.verb == Verb::move) {
            tidy.move_to(at = c.p3);
        } else if (segment.verb != Verb::close) {
            const PathSegment joined{segment.verb, {at, c.p1, c.p2, c.p3}};
            if (!has_length(joined, shortest)) return;
            segment.verb == Verb::line ? tidy.line_to(c.p3) : tidy.cubic_to(c.p1, c.p2, c.p3);
            at = c.p3;
        }
    });
    if (tidy.verbs.size() < 2) return {};
    if (!is_closed(part)) return tidy;
    if (is_close(tidy.points.front(), tidy.points.back(), shortest)) {
        if (tidy.verbs.back() == Verb::line && tidy.verbs.size() > 2) {
            tidy.verbs.pop_back();
            tidy.points.pop_back();
        } else {
            tidy.points.back() = tidy.points.front();
        }
    }
    tidy.close();
    return tidy;
}

void append(Path& path, const Path& more) {
    path.verbs.insert(path.verbs.end(), more.verbs.begin(), more.verbs.end());
    path.points.insert(path.points.end(), more.points.begin(), more.points.end());
}

using Polygon = std::vector<Vec2>;

Polygon to_polygon(const Path& ring) {
    constexpr int kSteps = 8;  // to tell what lies in what, not to draw
    Polygon polygon;
    walk_path(ring, [&](const PathSegment& segment) {
        const int steps = segment.verb == Verb::cubic ? kSteps : 1;
        if (segment.verb == Verb::close && segment.curve.p3 == segment.curve.p0) return;
        for (int i = 1; segment.verb != Verb::move && i <= steps; ++i) {
            polygon.push_back(eval(segment.curve, static_cast<double>(i) / steps));
        }
    });
    return polygon;
}

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

struct Edge {
    Vec2 a, b;
    double left() const { return std::min(a.x, b.x); }
    double right() const { return std::max(a.x, b.x); }
};

// Properly: in one point inside both.
bool edges_cross(const Edge& e, const Edge& f) {
    const auto side = [](const Edge& line, Vec2 p) { return cross(line.b - line.a, p - line.a); };
    return side(e, f.a) * side(e, f.b) < 0 && side(f, e.a) * side(f, e.b) < 0;
}

std::vector<Edge> edges_of(const std::vector<Polygon>& polygons) {
    std::vector<Edge> edges;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
        }
    }
    return edges;
}

// True if it can't be told.
bool may_cross(const std::vector<Polygon>& polygons) {
    std::vector<Edge> edges = edges_of(polygons);
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& e, const Edge& f) { return e.left() < f.left(); });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size() && edges[j].left() <= edges[i].right(); ++j) {
            if (++pairs > kMostPairs || edges_cross(edges[i], edges[j])) return true;
        }
    }
    return edges.size() * polygons.size() > kMostPairs;  // the nesting's cost
}

bool is_inside(Vec2 p, const Polygon& polygon) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2 a = polygon[i], b = polygon[j];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
    }
    return inside;
}

// By most of five corners: rings may touch in the others.
bool lies_in(const Polygon& inner, const Polygon& outer) {
    constexpr std::size_t kAsked = 5;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < kAsked; ++i) {
        inside += is_inside(inner[i * inner.size() / kAsked], outer) ? 1 : 0;
    }
    return inside * 2 > kAsked;
}

// Turns outlines one way and holes the other, and drops what changes nothing, by counting for each
// ring how often the others wind around it; false if they cross.
bool orient_by_nesting(std::vector<Path>& rings, bool even_odd) {
    std::vector<Polygon> polygons;
    std::vector<int> turns;
    for (const Path& ring : rings) {
        polygons.push_back(to_polygon(ring));
        turns.push_back(signed_area(ring) < 0 ? -1 : 1);
    }
    if (may_cross(polygons)) return false;
    const auto is_filled = [&](int winding) { return even_odd ? winding % 2 != 0 : winding != 0; };
    std::vector<Path> oriented;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        int outside = 0;
        for (std::size_t j = 0; j < rings.size(); ++j) {
            if (j != i && lies_in(polygons[i], polygons[j])) outside += turns[j];
        }
        const bool fills = is_filled(outside + turns[i]);
        if (fills == is_filled(outside)) continue;
        oriented.push_back(fills == (turns[i] > 0) ? rings[i] : reversed(rings[i]));
    }
    rings = std::move(oriented);
    return true;
}

// Turns all of them if the largest is a hole: what is wound and what is not stays the same.
void orient_by_largest(std::vector<Path>& rings) {
    double largest = 0;
    for (const Path& ring : rings) {
        const double area = signed_area(ring);
        if (std::abs(area) > std::abs(largest)) largest = area;
    }
    if (largest >= 0) return;
    for (Path& ring : rings)
        ring = reversed(ring);
}

// Turns holes that have no outline around them: they are none. False if there was one.
bool turn_stray_holes(std::vector<Path>& rings) {
    Bounds outlines;
    for (const Path& ring : rings) {
        if (signed_area(ring) >= 0) outlines.include(bounds(ring));
    }
    bool is_exact = true;
    for (Path& ring : rings) {
        const Bounds box = bounds(ring);
        const bool lies_within = outlines.contains(box.min) && outlines.contains(box.max);
        if (signed_area(ring) >= 0 || lies_within) continue;
        ring = reversed(ring);
        is_exact = false;
    }
    return is_exact;
}

}  // namespace

bool is_closed(const Path& path) {
    for (std::size_t i = 0; i < path.verbs.size(); ++i) {
        const bool ends = i + 1 == path.verbs.size() || path.verbs[i + 1] == Verb::move;
        if (ends && path.verbs[i] != Verb::close) return false;
    }
    return true;
}

Path closed(const Path& path) {
    Path result;
    for (Path& part : subpaths(path)) {
        if (!is_closed(part)) part.close();
        append(result, part);
    }
    return result;
}

Path without_short_segments(const Path& path, double shortest) {
    Path result;
    for (const Path& part : subpaths(path))
        append(result, tidy_subpath(part, shortest));
    return result;
}

FillRings fill_rings(const Path& path, bool even_odd) {
    std::vector<Path> rings = subpaths(closed(path));
    // Without an inside: a line there and back.
    std::erase_if(rings, [](const Path& ring) { return ring.points.size() < 3; });
    FillRings result;
    const bool is_simple = !even_odd && rings.size() == 1;
    if (is_simple || !orient_by_nesting(rings, even_odd)) {
        orient_by_largest(rings);
        result.is_exact = turn_stray_holes(rings) && !even_odd;
    }
    std::stable_partition(rings.begin(), rings.end(),
                          [](const Path& ring) { return signed_area(ring) >= 0; });
    for (const Path& ring : rings)
        append(result.path, ring);
    return result;
}

}  // namespace edaha
