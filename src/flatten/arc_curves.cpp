// SPDX-License-Identifier: MIT
#include "flatten/arc_curves.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 256;
// Ends of straight lines are moved by rounding alone, a few steps of the grid: that needs no cut.
constexpr double kRounding_px = 1.0 / 256;

// Of what both sides of a region may stray: half of it and they could meet.
constexpr double kShareOfWidth = 0.3;

// Where along its run a node lies: the end of the use before it.
struct Junction {
    std::uint32_t node = 0;
    double length = 0;  // of the polyline up to it
    double place = 0;   // in pieces
};

struct FittedRun {
    ArcCurves::RunCurve curve;
    std::vector<Junction> junctions;           // the inner ones, in order
    std::uint32_t start = kNone, end = kNone;  // nodes, of open runs
};

// A cubic's parameter nearest to a point, from a guess (Newton's method).
double nearest_parameter(const Cubic& c, Vec2 p, double t) {
    for (int i = 0; i < 4; ++i) {
        const Vec2 slope = derivative(c, t);
        const double speed2 = glm::dot(slope, slope);
        if (!(speed2 > 0)) break;
        t = std::clamp(t - glm::dot(eval(c, t) - p, slope) / speed2, 0.0, 1.0);
    }
    return t;
}

CurvePiece sub_piece(const CurvePiece& piece, double from, double to) {
    const Cubic c = sub_cubic(piece.curve, from, to);
    return {piece.straight ? line_cubic(c.p0, c.p3) : c, piece.straight, 0};
}

class Fitter {
  public:
    Fitter(const ArcGraph& graph, const RunSet& runs, const FitParams& params)
        : graph_(graph), map_(graph.map), runs_(runs), params_(params) {}

    ArcCurves fit() {
        fitted_.resize(runs_.runs.size());
        for_each_index(fitted_.size(), kWorthThreads, [&](std::size_t i) { fit_run(i); });
        place_nodes();
        for_each_index(fitted_.size(), kWorthThreads, [&](std::size_t i) { pin_ends(fitted_[i]); });
        return collect();
    }

  private:
    Vec2 position(std::uint32_t node) const {
        return to_vec(map_.nodes[node]) / params_.steps_per_px;
    }

    void fit_run(std::size_t index) {
        const Run& run = runs_.runs[index];
        FittedRun& fitted = fitted_[index];
        const std::span<const ArcUse> uses = runs_.of(run);
        std::vector<Vec2> points;
        double length = 0;
        const auto add = [&](std::uint32_t node) {
            const Vec2 p = position(node);
            if (!points.empty() && p == points.back()) return;
            if (!points.empty()) length += glm::distance(points.back(), p);
            points.push_back(p);
        };
        for (const ArcUse& use : uses) {
            add(map_.origin(graph_.first_half_edge(use)));
            if (&use != uses.data())
                fitted.junctions.push_back({graph_.start_node(use), length, 0});
            for (std::size_t i = 0; i < graph_.size(use.arc); ++i)
                add(map_.target(graph_.half_edge(use, i)));
        }
        if (run.closed && points.front() != points.back())
            add(map_.origin(graph_.first_half_edge(uses[0])));
        if (graph_.arcs.arcs[uses[0].arc].closed) turn_to_seam(points);
        if (!run.closed) {
            fitted.start = graph_.start_node(uses.front());
            fitted.end = graph_.end_node(uses.back());
        }
        fitted.curve = {smooth_line(points, run.closed, params_for(uses)), run.closed};
        place_junctions(fitted);
    }

    SmoothParams params_for(std::span<const ArcUse> uses) const {
        SmoothParams smooth = params_.smooth;
        double narrowest = HUGE_VAL;
        for (const ArcUse& use : uses) {
            const std::uint32_t h = graph_.first_half_edge(use);
            narrowest =
                std::min({narrowest, double(params_.width[h]), double(params_.width[twin(h)])});
        }
        smooth.tolerance = std::min(smooth.tolerance, kShareOfWidth * narrowest);
        smooth.noise = std::min(smooth.noise, 0.5 * kShareOfWidth * narrowest);
        return smooth;
    }

    static void turn_to_seam(std::vector<Vec2>& points) {
        const std::size_t seam = sharpest_vertex(points);
        points.pop_back();
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(seam),
                    points.end());
        points.push_back(points.front());
    }

    void place_junctions(FittedRun& fitted) const {
        const std::vector<CurvePiece>& pieces = fitted.curve.pieces;
        std::size_t i = 0;
        double before = 0;
        for (Junction& junction : fitted.junctions) {
            while (i + 1 < pieces.size() && pieces[i].end <= junction.length)
                ++i;
            const double begin = i == 0 ? 0 : pieces[i - 1].end;
            const double size = pieces[i].end - begin;
            const double guess = std::clamp((junction.length - begin) / size, 0.0, 1.0);
            const Vec2 p = position(junction.node);
            double t = nearest_parameter(pieces[i].curve, p, guess);
            if (glm::distance(pieces[i].curve.p0, p) < kRounding_px) t = 0;
            if (glm::distance(pieces[i].curve.p3, p) < kRounding_px) t = 1;
            junction.place = before = std::max(before, static_cast<double>(i) + t);
        }
    }

    static Vec2 at(const ArcCurves::RunCurve& curve, double place) {
        const auto i = std::min(static_cast<std::size_t>(place), curve.pieces.size() - 1);
        return eval(curve.pieces[i].curve, place - static_cast<double>(i));
    }

    // A node lies where the run through it passes; else where it is.
    void place_nodes() {
        placed_.assign(map_.nodes.size(), Vec2(HUGE_VAL));
        for (const FittedRun& run : fitted_) {
            for (const Junction& junction : run.junctions)
                placed_[junction.node] = at(run.curve, junction.place);
        }
        for (std::size_t i = 0; i < fitted_.size(); ++i) {
            const ArcUse first = runs_.uses[runs_.runs[i].first];
            if (fitted_[i].start == kNone && !graph_.arcs.arcs[first.arc].closed)
                placed_[graph_.start_node(first)] = fitted_[i].curve.pieces.front().curve.p0;
        }
    }

    void pin_ends(FittedRun& run) const {
        if (run.start == kNone) return;
        pin(run, run.start, false);
        pin(run, run.end, true);
    }

    // Moves the end of a run to its node. What lies between the end and the first junction bends
    // with it, no more: other runs end at the junction.
    void pin(FittedRun& run, std::uint32_t node, bool at_end) const {
        const Vec2 to = placed_[node].x == HUGE_VAL ? position(node) : placed_[node];
        std::vector<CurvePiece>& pieces = run.curve.pieces;
        const CurvePiece& outer = at_end ? pieces.back() : pieces.front();
        const Vec2 shift = to - (at_end ? outer.curve.p3 : outer.curve.p0);
        if (shift == Vec2(0)) return;
        if (glm::length(shift) > kRounding_px) cut_at_junction(run, at_end);
        CurvePiece& piece = at_end ? pieces.back() : pieces.front();
        Cubic& c = piece.curve;
        if (at_end) {
            c.p3 = to, c.p2 += shift;
        } else {
            c.p0 = to, c.p1 += shift;
        }
        if (piece.straight) c = line_cubic(c.p0, c.p3);
    }

    static void cut_at_junction(FittedRun& run, bool at_end) {
        if (run.junctions.empty()) return;
        std::vector<CurvePiece>& pieces = run.curve.pieces;
        const double place = at_end ? run.junctions.back().place : run.junctions.front().place;
        const auto i = at_end ? pieces.size() - 1 : std::size_t{0};
        const double t = place - static_cast<double>(i);
        if (!(t > 0 && t < 1)) return;
        const CurvePiece whole = pieces[i];
        pieces[i] = sub_piece(whole, 0, t);
        const CurvePiece rest = sub_piece(whole, t, 1);
        pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
        for (Junction& junction : run.junctions) {
            const double u = junction.place - static_cast<double>(i);
            if (u <= 0) continue;
            junction.place = static_cast<double>(i);
            if (u <= t) {
                junction.place += u / t;
            } else {
                junction.place += u >= 1 ? u + 1 : 1 + (u - t) / (1 - t);
            }
        }
    }

    ArcCurves collect() {
        ArcCurves result;
        result.span_of.resize(graph_.arcs.arcs.size());
        for (std::uint32_t r = 0; r < fitted_.size(); ++r) {
            FittedRun& fitted = fitted_[r];
            double from = 0;
            const std::span<const ArcUse> uses = runs_.of(runs_.runs[r]);
            for (std::size_t i = 0; i < uses.size(); ++i) {
                const double to = i < fitted.junctions.size()
                                      ? fitted.junctions[i].place
                                      : static_cast<double>(fitted.curve.pieces.size());
                result.span_of[uses[i].arc] =
                    uses[i].forward ? CurveSpan{r, from, to} : CurveSpan{r, to, from};
                from = to;
            }
            result.runs.push_back(std::move(fitted.curve));
        }
        return result;
    }

    const ArcGraph& graph_;
    const PlanarMap& map_;
    const RunSet& runs_;
    FitParams params_;
    std::vector<FittedRun> fitted_;
    std::vector<Vec2> placed_;  // a node; infinite where no run passes
};

void append_forward(std::vector<CurvePiece>& pieces, const ArcCurves::RunCurve& run, double from,
                    double to) {
    auto i = static_cast<std::size_t>(from);
    double t = from - static_cast<double>(i);
    for (; i < run.pieces.size() && static_cast<double>(i) + t < to; ++i, t = 0) {
        const double u = std::min(1.0, to - static_cast<double>(i));
        pieces.push_back(t == 0 && u == 1 ? run.pieces[i] : sub_piece(run.pieces[i], t, u));
    }
}

}  // namespace

ArcCurves fit_arcs(const ArcGraph& graph, const RunSet& runs, const FitParams& params) {
    return Fitter(graph, runs, params).fit();
}

std::vector<CurveSpan> joined(std::span<const CurveSpan> spans) {
    std::vector<CurveSpan> result;
    for (const CurveSpan& span : spans) {
        if (span.run == kNone) continue;
        if (!result.empty() && result.back().run == span.run && result.back().to == span.from &&
            (result.back().from < result.back().to) == (span.from < span.to)) {
            result.back().to = span.to;
        } else {
            result.push_back(span);
        }
    }
    return result;
}

std::vector<CurvePiece> pieces_along(const ArcCurves& curves, std::span<const CurveSpan> spans) {
    std::vector<CurvePiece> pieces;
    for (const CurveSpan& span : joined(spans)) {
        const std::size_t first = pieces.size();
        const ArcCurves::RunCurve& run = curves.runs[span.run];
        append_forward(pieces, run, std::min(span.from, span.to), std::max(span.from, span.to));
        if (span.from <= span.to) continue;
        std::reverse(pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end());
        for (std::size_t i = first; i < pieces.size(); ++i)
            pieces[i].curve = reversed(pieces[i].curve);
    }
    return pieces;
}

void append_pieces(Path& path, std::span<const CurvePiece> pieces, const Affine& page_from_px) {
    constexpr double kShortest_px = 1e-3;
    if (pieces.empty()) return;
    Vec2 at = pieces.front().curve.p0;
    if (path.empty() || path.verbs.back() == Verb::close) path.move_to(transform(page_from_px, at));
    for (const CurvePiece& piece : pieces) {
        const Cubic& c = piece.curve;
        const double reach =
            std::max({glm::distance(at, c.p1), glm::distance(at, c.p2), glm::distance(at, c.p3)});
        if (reach < kShortest_px) continue;
        at = c.p3;
        if (piece.straight) {
            path.line_to(transform(page_from_px, c.p3));
        } else {
            path.cubic_to(transform(page_from_px, c.p1), transform(page_from_px, c.p2),
                          transform(page_from_px, c.p3));
        }
    }
}

}  // namespace edaha
