// SPDX-License-Identifier: MIT
#include "geometry/measure.h"

#include <span>

#include <glm/geometric.hpp>

#include "geometry/walk_path.h"

namespace edaha {
namespace {

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// One subpath, from its move on; a move without a segment is dropped.
void append_reversed(Path& out, std::span<const Verb> verbs, std::span<const Vec2> points) {
    if (verbs.size() < 2) return;
    const bool closed = verbs.back() == Verb::close;
    const Vec2 end = closed ? points.front() : points.back();
    out.move_to(end);
    if (closed && points.back() != end) out.line_to(points.back());
    const std::size_t segments = verbs.size() - (closed ? 1 : 0);
    std::size_t at = points.size() - 1;
    for (std::size_t i = segments; i-- > 1;) {
        if (verbs[i] == Verb::cubic) {
            out.cubic_to(points[at - 1], points[at - 2], points[at - 3]);
            at -= 3;
        } else {  // the first line of a closed subpath becomes its close
            --at;
            if (i > 1 || !closed) out.line_to(points[at]);
        }
    }
    if (closed) out.close();
}

}  // namespace

double swept_area(const Cubic& c) {
    return (6 * cross(c.p0, c.p1) + 3 * cross(c.p0, c.p2) + cross(c.p0, c.p3) +
            3 * cross(c.p1, c.p2) + 3 * cross(c.p1, c.p3) + 6 * cross(c.p2, c.p3)) /
           20;
}

double signed_area(const Path& path) {
    double area = 0;
    Vec2 origin(0);  // per subpath: areas far from the page's corner don't cancel
    walk_path(path, [&](const PathSegment& segment) {
        const Cubic& c = segment.curve;
        if (segment.verb == Verb::move) origin = c.p0;
        area += segment.verb == Verb::cubic
                    ? swept_area({c.p0 - origin, c.p1 - origin, c.p2 - origin, c.p3 - origin})
                    : cross(c.p0 - origin, c.p3 - origin) / 2;
    });
    return area;
}

double length(const Path& path) {
    double sum = 0;
    walk_path(path, [&](const PathSegment& segment) {
        sum += segment.verb == Verb::cubic ? arc_length(segment.curve)
                                           : glm::distance(segment.curve.p0, segment.curve.p3);
    });
    return sum;
}

Path transformed(const Affine& target_from_source, const Path& path) {
    Path out = path;
    for (Vec2& p : out.points)
        p = transform(target_from_source, p);
    return out;
}

Path reversed(const Path& path) {
    Path out;
    out.verbs.reserve(path.verbs.size() + 1);
    out.points.reserve(path.points.size() + 1);
    const std::span verbs(path.verbs);
    const std::span points(path.points);
    std::size_t verb = 0, point = 0;
    while (verb < verbs.size()) {
        const std::size_t first_verb = verb, first_point = point;
        do {
            point += verbs[verb] == Verb::cubic ? 3 : verbs[verb] == Verb::close ? 0 : 1;
            ++verb;
        } while (verb < verbs.size() && verbs[verb] != Verb::move);
        append_reversed(out, verbs.subspan(first_verb, verb - first_verb),
                        points.subspan(first_point, point - first_point));
    }
    return out;
}

}  // namespace edaha
