// SPDX-License-Identifier: MIT
#include "geometry/cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/walk_path.h"

namespace edaha {
namespace {

bool vec_less(Vec2 a, Vec2 b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

bool path_less(const Path& a, const Path& b) {
    const auto equal = [](Vec2 p, Vec2 q) { return p == q; };
    if (std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), equal)) {
        return a.verbs < b.verbs;
    }
    return std::lexicographical_compare(a.points.begin(), a.points.end(), b.points.begin(),
                                        b.points.end(), vec_less);
}

double fitting_grid(std::span<const Path> paths, double grid) {
    double reach = 0;
    for (const Path& path : paths) {
        for (const Vec2 p : path.points)
            reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
    }
    // A step short of the limit leaves room for rounding.
    while (reach / grid > kGridLimit - 2 && std::isfinite(reach))
        grid *= 2;
    return grid;
}

class ChordMaker {
  public:
    ChordMaker(double tolerance, double grid) : tolerance_(tolerance) { chords_.grid = grid; }

    void add(const Path& path, std::uint32_t id) {
        path_ = id;
        walk_path(path, [&](const PathSegment& segment) {
            if (segment.verb == Verb::move) {
                close();
                start_ = at_ = segment.curve.p0;
            } else if (segment.verb == Verb::close) {
                close();
            } else {
                add_curve(segment.curve, segment.verb != Verb::cubic);
            }
        });
        close();
    }

    Chords take() { return std::move(chords_); }

  private:
    GridPoint on_grid(Vec2 p) const {
        return {static_cast<std::int32_t>(std::floor(p.x / chords_.grid + 0.5)),
                static_cast<std::int32_t>(std::floor(p.y / chords_.grid + 0.5))};
    }

    void add_curve(const Cubic& cubic, bool straight) {
        at_ = cubic.p3;
        const int steps = straight ? 1 : flatten_steps(cubic, tolerance_);
        const auto curve = static_cast<std::uint32_t>(chords_.curves.size());
        const auto first = static_cast<std::uint32_t>(chords_.segments.size());
        chords_.curves.push_back({cubic, straight, first, static_cast<std::uint32_t>(steps)});
        GridPoint from = on_grid(cubic.p0);
        for (int i = 1; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            const GridPoint to = on_grid(i == steps ? cubic.p3 : eval(cubic, t));
            chords_.segments.push_back({from, to});
            chords_.curve_of.push_back(curve);
            chords_.ring_of.push_back(static_cast<std::uint32_t>(chords_.rings.size()));
            from = to;
        }
    }

    void close() {
        if (chords_.segments.size() == ring_first_) return;
        if (at_ != start_) add_curve(line_cubic(at_, start_), true);
        const auto end = static_cast<std::uint32_t>(chords_.segments.size());
        chords_.rings.push_back({path_, ring_first_, end});
        ring_first_ = end;
    }

    double tolerance_;
    Chords chords_;
    std::uint32_t path_ = 0, ring_first_ = 0;
    Vec2 start_{0}, at_{0};
};

// Goes from face to face, keeping each path's winding number; each face is entered once and left
// the same way.
class WindingWalk {
  public:
    WindingWalk(const Cover& cover, std::size_t paths) : cover_(cover), winding_(paths, 0) {}

    std::vector<std::uint32_t> covered() {
        const PlanarMap& map = cover_.map;
        std::vector<std::uint32_t> covered(map.faces(), 0);
        std::vector<std::uint8_t> seen(map.faces(), 0);
        std::vector<Visit> stack;
        seen[0] = 1;
        if (!map.loops_of(0).empty()) stack.push_back(enter(0, kNone));
        while (!stack.empty()) {
            Visit& visit = stack.back();
            if (visit.loop == map.first_loop[visit.face + 1]) {
                if (visit.way_in != kNone) cross_edge(twin(visit.way_in));
                stack.pop_back();
                continue;
            }
            const std::uint32_t h = visit.at;
            advance(visit);
            const std::uint32_t face = map.face_of(twin(h));
            if (seen[face]) continue;
            seen[face] = 1;
            cross_edge(h);
            covered[face] = winding_paths_ > 0;
            stack.push_back(enter(face, h));
        }
        return covered;
    }

  private:
    struct Visit {
        std::uint32_t face = 0, way_in = kNone;
        std::uint32_t loop = 0, at = 0;  // where on the border: place in face_loops, half-edge
    };

    Visit enter(std::uint32_t face, std::uint32_t way_in) const {
        const std::uint32_t loop = cover_.map.first_loop[face];
        return {face, way_in, loop, first_of(loop)};
    }
    std::uint32_t first_of(std::uint32_t place) const {
        return cover_.map.loops[cover_.map.face_loops[place]].first;
    }
    void advance(Visit& visit) const {
        visit.at = cover_.map.next[visit.at];
        if (visit.at != first_of(visit.loop)) return;
        ++visit.loop;
        if (visit.loop < cover_.map.first_loop[visit.face + 1]) visit.at = first_of(visit.loop);
    }

    // From the left of h to its right: what runs along h winds once less round there.
    void cross_edge(std::uint32_t h) {
        for (const EdgeUse& use : cover_.arrangement.uses_of(h / 2)) {
            int& winding = winding_[cover_.chords.rings[cover_.chords.ring_of[use.segment]].path];
            const bool along = use.forward == (h % 2 == 0);
            winding_paths_ -= winding != 0;
            winding += along ? -1 : 1;
            winding_paths_ += winding != 0;
        }
    }

    const Cover& cover_;
    std::vector<int> winding_;
    int winding_paths_ = 0;
};

}  // namespace

Cover cover_plane(std::span<const Path> paths, const CoverParams& params) {
    std::vector<std::uint32_t> order(paths.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return path_less(paths[a], paths[b]);
    });
    ChordMaker maker(params.tolerance, fitting_grid(paths, params.grid));
    for (std::uint32_t i = 0; i < order.size(); ++i)
        maker.add(paths[order[i]], i);
    Cover cover;
    cover.chords = maker.take();
    cover.arrangement = snap_round(cover.chords.segments);
    cover.map =
        build_planar_map(std::move(cover.arrangement.nodes), std::move(cover.arrangement.edges));
    cover.covered = WindingWalk(cover, paths.size()).covered();
    return cover;
}

CurvePlace curve_place(const Chords& chords, std::uint32_t ring, double place, bool forward) {
    const SourceRing& source = chords.rings[ring];
    const double around = source.end_chord - source.first_chord;
    const double chord = forward ? std::floor(place + 1e-9) : std::ceil(place - 1e-9) - 1;
    const double lap = std::floor(chord / around) * around;
    const auto index = source.first_chord + static_cast<std::uint32_t>(chord - lap);
    CurvePlace found;
    found.curve = chords.curve_of[index];
    const SourceCurve& curve = chords.curves[found.curve];
    found.first = lap + (curve.first_chord - source.first_chord);
    found.t = std::clamp((place - found.first) / curve.chords, 0.0, 1.0);
    return found;
}

double fraction_at(const GridSegment& chord, GridPoint node) {
    if (node == chord.a) return 0;
    if (node == chord.b) return 1;
    const GridVector d = chord.b - chord.a;
    const double along = static_cast<double>(dot(d, node - chord.a));
    return std::clamp(along / static_cast<double>(dot(d, d)), 0.0, 1.0);
}

}  // namespace edaha
