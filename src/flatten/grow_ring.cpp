// SPDX-License-Identifier: MIT
#include "flatten/grow_ring.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/walk_path.h"

namespace edaha {
namespace {

// Sharper corners would grow spikes.
constexpr double kMiterLimit = 2;

Vec2 to_right(Vec2 direction) {
    return {direction.y, -direction.x};
}

// How far the corner between two pieces moves, so that it lies on both moved lines.
Vec2 miter(Vec2 in, double by_in, Vec2 out, double by_out) {
    const Vec2 a = to_right(in), b = to_right(out);
    const double turn = a.x * b.y - a.y * b.x;
    const double by = std::abs(by_in) > std::abs(by_out) ? by_in : by_out;
    const double most = kMiterLimit * std::abs(by);
    if (std::abs(turn) < 1e-3) return a * by;
    const Vec2 shift((by_in * b.y - by_out * a.y) / turn, (by_out * a.x - by_in * b.x) / turn);
    const double length = glm::length(shift);
    return length > most ? shift * (most / length) : shift;
}

struct Shifts {
    Vec2 start{0}, end{0};
};

CurvePiece moved(const GrownPiece& grown, const Shifts& shifts) {
    const Cubic& c = grown.piece.curve;
    CurvePiece piece = grown.piece;
    const Vec2 from = c.p0 + shifts.start, to = c.p3 + shifts.end;
    if (piece.straight) {
        piece.curve = line_cubic(from, to);
        return piece;
    }
    // Arms grow with the chord, which is right for arcs of circles.
    const double chord = glm::distance(c.p0, c.p3);
    const double ratio = chord > 0 ? glm::distance(from, to) / chord : 1;
    piece.curve = {from, from + (c.p1 - c.p0) * ratio, to - (c.p3 - c.p2) * ratio, to};
    return piece;
}

}  // namespace

std::vector<CurvePiece> grow_ring(std::span<const GrownPiece> ring) {
    std::vector<Shifts> shifts(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const GrownPiece& in = ring[i];
        const GrownPiece& out = ring[(i + 1) % ring.size()];
        Vec2& end = shifts[i].end;
        Vec2& start = shifts[(i + 1) % ring.size()].start;
        const Vec2 way_in = end_direction(in.piece.curve);
        const Vec2 way_out = start_direction(out.piece.curve);
        if (in.end == GrownEnd::butt) end = to_right(way_in) * in.by;
        if (out.start == GrownEnd::butt) start = to_right(way_out) * out.by;
        if (in.by * out.by > 0 && in.end == GrownEnd::open && out.start == GrownEnd::open) {
            start = end = miter(way_in, in.by, way_out, out.by);
        }
    }
    std::vector<CurvePiece> result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Cubic& c = ring[i].piece.curve;
        if (!result.empty() && result.back().curve.p3 != c.p0 + shifts[i].start)
            result.push_back({line_cubic(result.back().curve.p3, c.p0 + shifts[i].start), true, 0});
        result.push_back(ring[i].by != 0 ? moved(ring[i], shifts[i]) : ring[i].piece);
        const Vec2 next = ring[(i + 1) % ring.size()].piece.curve.p0;
        const bool returns = ring[i].by != 0 && ring[i].end == GrownEnd::butt;
        if (returns) result.push_back({line_cubic(result.back().curve.p3, next), true, 0});
    }
    return result;
}

}  // namespace edaha
