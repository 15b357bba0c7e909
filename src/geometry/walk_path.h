// SPDX-License-Identifier: MIT
#pragma once
#include "geometry/bezier.h"
#include "geometry/path.h"

namespace edaha {

// One step of a path. A straight one is a cubic with its control points at the thirds.
struct PathSegment {
    Verb verb = Verb::move;  // move: a new subpath, all four points the same
    Cubic curve;
};

inline Cubic line_cubic(Vec2 a, Vec2 b) {
    return {a, a + (b - a) / 3.0, b - (b - a) / 3.0, b};
}

// Calls visit(PathSegment) for every verb in order; close comes as the straight way back to the
// subpath's start, even where that has no length.
template <typename Visit>
void walk_path(const Path& path, Visit&& visit) {
    std::size_t next = 0;
    Vec2 start(0), at(0);
    for (const Verb verb : path.verbs) {
        if (verb == Verb::move) {
            start = at = path.points[next++];
            visit(PathSegment{verb, {at, at, at, at}});
        } else if (verb == Verb::line) {
            visit(PathSegment{verb, line_cubic(at, path.points[next])});
            at = path.points[next++];
        } else if (verb == Verb::cubic) {
            const Vec2* p = &path.points[next];
            visit(PathSegment{verb, {at, p[0], p[1], p[2]}});
            at = p[2];
            next += 3;
        } else {
            visit(PathSegment{verb, line_cubic(at, start)});
            at = start;
        }
    }
}

}  // namespace edaha
