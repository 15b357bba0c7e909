// SPDX-License-Identifier: MIT
#include "geometry/measure.h"

#include <glm/geometric.hpp>

#include "geometry/walk_path.h"

namespace edaha {
namespace {

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// One subpath of `path`, given as its segments without the move.
void append_reversed(Path& out, const std::vector<PathSegment>& segments) {
    const bool closed = segments.back().verb == Verb::close;
    const Vec2 end = segments.back().curve.p3;
    out.move_to(end);
    for (std::size_t i = segments.size(); i-- > 0;) {
        const auto& [verb, c] = segments[i];
        const bool last = i == 0;
        if (verb == Verb::cubic) {
            out.cubic_to(c.p2, c.p1, c.p0);
        } else if (verb == Verb::line ? !(last && closed) : c.p0 != end) {
            out.line_to(c.p0);  // the first line of a closed subpath becomes its close
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
    std::vector<PathSegment> segments;
    segments.reserve(path.verbs.size());
    const auto flush = [&] {
        if (!segments.empty()) append_reversed(out, segments);
        segments.clear();
    };
    walk_path(path, [&](const PathSegment& segment) {
        if (segment.verb == Verb::move) {
            flush();
        } else {
            segments.push_back(segment);
            if (segment.verb == Verb::close) flush();
        }
    });
    flush();
    return out;
}

}  // namespace edaha
