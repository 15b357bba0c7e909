// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "geometry/path.h"
#include "geometry/walk_path.h"

namespace edaha::shapes {

// Positive (signed_area > 0) closed shapes for the tests of this room.

inline constexpr double kPi = 3.14159265358979323846;

inline Path polygon(std::initializer_list<Vec2> points) {
    Path path;
    for (const Vec2 p : points)
        path.empty() ? path.move_to(p) : path.line_to(p);
    path.close();
    return path;
}

inline Path box(double x0, double y0, double x1, double y1) {
    return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

// Circle of `arcs` equal cubics; with four the radius is up to 2.8e-4 of itself too long.
inline Path circle(Vec2 centre, double radius, int arcs = 4) {
    const double step = 2 * kPi / arcs;
    const double arm = 4.0 / 3 * std::tan(step / 4) * radius;
    const auto at = [&](int i) {
        const double a = i % arcs * step;
        return centre + radius * Vec2(std::cos(a), std::sin(a));
    };
    const auto along = [&](int i) {
        const double a = i % arcs * step;
        return arm * Vec2(-std::sin(a), std::cos(a));
    };
    Path path;
    path.move_to(at(0));
    for (int i = 0; i < arcs; ++i) {
        path.cubic_to(at(i) + along(i), at(i + 1) - along(i + 1), at(i + 1));
    }
    path.close();
    return path;
}

inline void append(Path& path, const Path& more) {
    path.verbs.insert(path.verbs.end(), more.verbs.begin(), more.verbs.end());
    path.points.insert(path.points.end(), more.points.begin(), more.points.end());
}

// No two straight segments of the path cross properly: exact for corners on a binary grid.
inline bool lines_dont_cross(const Path& path) {
    const auto side = [](Vec2 a, Vec2 b, Vec2 c) {
        const double d = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        return (d > 0) - (d < 0);
    };
    std::vector<Cubic> lines;
    walk_path(path, [&](const PathSegment& segment) {
        if (segment.verb == Verb::line || segment.verb == Verb::close) {
            lines.push_back(segment.curve);
        }
    });
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 a = lines[i].p0, b = lines[i].p3, c = lines[j].p0, d = lines[j].p3;
            if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) {
                return false;
            }
        }
    }
    return true;
}

// Repeatable numbers in [0, 1): a linear congruential generator, enough for test scenes.
struct Random {
    std::uint64_t state = 1;
    double operator()() {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<double>(state >> 11) * 0x1p-53;
    }
};

}  // namespace edaha::shapes
