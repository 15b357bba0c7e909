// SPDX-License-Identifier: MIT
#include "geometry/unite.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/border_runs.h"
#include "geometry/measure.h"
#include "geometry/refine_crossings.h"
#include "geometry/region_rings.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

struct Piece {
    Cubic cubic;  // ends on grid nodes
    bool straight = false;
};

using Pieces = std::vector<Piece>;

bool vec_less(Vec2 a, Vec2 b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// Moves the ends, and with each its arm.
Cubic with_ends(const Cubic& c, Vec2 start, Vec2 end) {
    return {start, c.p1 + (start - c.p0), c.p2 + (end - c.p3), end};
}

// Cuts runs into pieces of single source curves.
class PieceCutter {
  public:
    explicit PieceCutter(const Chords& chords) : chords_(chords) {}

    void add(const BorderRun& run) {
        Vec2 from = position(run.start);
        double place = run.begin;
        while (std::abs(run.end - place) > 1e-9) {
            const CurvePlace entry = curve_place(chords_, run.ring, place, run.forward);
            const SourceCurve& curve = chords_.curves[entry.curve];
            const double last = entry.first + curve.chords;
            const double stop =
                run.forward ? std::min(run.end, last) : std::max(run.end, entry.first);
            const bool ends = std::abs(run.end - stop) <= 1e-9;
            const Vec2 to = position(ends ? run.stop : corner_after(curve, run.forward));
            const double t = std::clamp((stop - entry.first) / curve.chords, 0.0, 1.0);
            add_piece(curve, {entry.t, t}, from, to);
            from = to;
            place = stop;
        }
    }

    Pieces take() { return std::move(pieces_); }

  private:
    Vec2 position(GridPoint p) const { return to_vec(p) * chords_.grid; }

    GridPoint corner_after(const SourceCurve& curve, bool forward) const {
        return forward ? chords_.segments[curve.first_chord + curve.chords - 1].b
                       : chords_.segments[curve.first_chord].a;
    }

    void add_piece(const SourceCurve& curve, Vec2 t, Vec2 from, Vec2 to) {
        if (curve.straight) {
            pieces_.push_back({line_cubic(from, to), true});
        } else {
            pieces_.push_back({with_ends(sub_cubic(curve.cubic, t[0], t[1]), from, to), false});
        }
    }

    const Chords& chords_;
    Pieces pieces_;
};

bool within(const Cubic& c, double reach) {
    return glm::distance(c.p0, c.p3) <= reach && glm::distance(c.p0, c.p1) <= reach &&
           glm::distance(c.p0, c.p2) <= reach;
}

// Takes out what has no length and curved pieces (or straight ones beside curved ones) smaller
// than the tolerance; the piece after takes over their start.
void drop_specks(Pieces& pieces, double tolerance) {
    Pieces kept;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& after = pieces[(i + 1) % pieces.size()];
        const bool polygon = pieces[i].straight && after.straight;
        if (!within(pieces[i].cubic, polygon ? 0 : tolerance)) {
            kept.push_back(pieces[i]);
            continue;
        }
        Piece& heir = i + 1 < pieces.size() ? pieces[i + 1] : kept.empty() ? pieces[0] : kept[0];
        const Vec2 start = pieces[i].cubic.p0, end = heir.cubic.p3;
        heir.cubic = heir.straight ? line_cubic(start, end) : with_ends(heir.cubic, start, end);
    }
    pieces = std::move(kept);
}

// Straight pieces that go on in the same direction, exactly: ends are multiples of the grid.
bool goes_on(const Piece& a, const Piece& b) {
    if (!a.straight || !b.straight) return false;
    const Vec2 d = a.cubic.p3 - a.cubic.p0, e = b.cubic.p3 - b.cubic.p0;
    return d.x * e.y == d.y * e.x && glm::dot(d, e) > 0;
}

void join_lines(Pieces& pieces) {
    const auto corner = [&](std::size_t i) {
        return !goes_on(pieces[(i + pieces.size() - 1) % pieces.size()], pieces[i]);
    };
    std::size_t first = 0;
    while (first < pieces.size() && !corner(first))
        ++first;
    if (first == pieces.size()) return;
    std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end());
    Pieces joined;
    for (const Piece& piece : pieces) {
        if (!joined.empty() && goes_on(joined.back(), piece)) {
            joined.back().cubic = line_cubic(joined.back().cubic.p0, piece.cubic.p3);
        } else {
            joined.push_back(piece);
        }
    }
    pieces = std::move(joined);
}

void start_at_smallest(Pieces& pieces) {
    const auto smallest = std::min_element(
        pieces.begin(), pieces.end(),
        [](const Piece& a, const Piece& b) { return vec_less(a.cubic.p0, b.cubic.p0); });
    std::rotate(pieces.begin(), smallest, pieces.end());
}

Path closed_path(const Pieces& pieces) {
    Path path;
    path.move_to(pieces.front().cubic.p0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Cubic& c = pieces[i].cubic;
        if (!pieces[i].straight) {
            path.cubic_to(c.p1, c.p2, c.p3);
        } else if (i + 1 < pieces.size()) {  // the last line is the closing one
            path.line_to(c.p3);
        }
    }
    path.close();
    return path;
}

// A ring as a path; empty if nothing is left of it.
Path make_ring(const Cover& cover, std::span<const std::uint32_t> half_edges,
               std::span<const std::uint8_t> touching, double tolerance) {
    // Two outlines within the tolerance of one curve are within two of each other; the grid adds
    // a step.
    const double reach = 2 * tolerance / cover.chords.grid + 1;
    PieceCutter cutter(cover.chords);
    const std::vector<BorderRun> runs = border_runs(cover, half_edges, touching, reach);
    for (const BorderRun& run : refine_crossings(cover.chords, runs, tolerance))
        cutter.add(run);
    Pieces pieces = cutter.take();
    drop_specks(pieces, tolerance);
    if (pieces.empty()) return {};
    join_lines(pieces);
    start_at_smallest(pieces);
    return closed_path(pieces);
}

double polyline_length(const Cover& cover, std::span<const std::uint32_t> half_edges) {
    double length = 0;
    for (const std::uint32_t h : half_edges) {
        length += glm::distance(to_vec(cover.map.nodes[cover.map.origin(h)]),
                                to_vec(cover.map.nodes[cover.map.target(h)]));
    }
    return length;
}

// Rings to be left out: tiny ones, and holes narrower (area over half the border) than the
// tolerance.
bool is_speck(const Cover& cover, const RegionRings& rings, const RegionRings::Ring& ring,
              const UniteParams& params) {
    const double grid = cover.chords.grid;
    const double area = std::abs(ring.area) * grid * grid;
    if (area < params.min_area) return true;
    const double border = polyline_length(cover, rings.of(ring)) * grid;
    return ring.area < 0 && 2 * area < border * params.tolerance;
}

}  // namespace

Path unite(std::span<const Path> closed, const UniteParams& params) {
    const Cover cover = cover_plane(closed, {params.tolerance, params.grid});
    const RegionRings rings = trace_region_rings(cover.map, cover.covered);
    const std::vector<std::uint8_t> touching = touching_nodes(cover.map, rings);
    std::vector<Path> outlines, holes;
    for (const RegionRings::Ring& ring : rings.rings) {
        if (is_speck(cover, rings, ring, params)) continue;
        Path path = make_ring(cover, rings.of(ring), touching, params.tolerance);
        if (path.empty() || (signed_area(path) > 0) != (ring.area > 0)) continue;
        (ring.area > 0 ? outlines : holes).push_back(std::move(path));
    }
    Path result;
    for (std::vector<Path>* group : {&outlines, &holes}) {
        std::stable_sort(group->begin(), group->end(), [](const Path& a, const Path& b) {
            return vec_less(a.points[0], b.points[0]);
        });
        for (const Path& path : *group) {
            result.verbs.insert(result.verbs.end(), path.verbs.begin(), path.verbs.end());
            result.points.insert(result.points.end(), path.points.begin(), path.points.end());
        }
    }
    return result;
}

}  // namespace edaha
