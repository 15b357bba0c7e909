// SPDX-License-Identifier: MIT
#include "flatten/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "flatten/covered_strokes.h"
#include "flatten/kept_edges.h"
#include "flatten/taper.h"
#include "geometry/walk_path.h"

namespace edaha {
namespace {

// Costs of going on at a node, as 1 - cosine of the turn: 0 straight on, 1 a right angle.
constexpr double kMostTurn = 1.3;  // 107 degrees, so that none of 120 comes about
constexpr double kOtherKind = 0.25;
constexpr double kSameRun = 0.5;  // saved: one curve is not cut

// Kinds that may share a stroke: all that a surface ends by, all that lies on it.
int family(LineKind kind) {
    if (kind <= LineKind::contour) return 0;
    return kind == LineKind::border ? 1 : 2;
}

constexpr double kMostReversal = -0.5;  // cosine of 120 degrees

// Moves the start of a piece.
void start_at(CurvePiece& piece, Vec2 start) {
    Cubic& c = piece.curve;
    c.p1 += start - c.p0;
    c.p0 = start;
    if (piece.straight) c = line_cubic(c.p0, c.p3);
}

// In one line: pieces that were apart are tied by a line, or by moving the second one where that is
// not seen; those too short to be seen are left out.
std::vector<CurvePiece> tied(std::span<const CurvePiece> pieces) {
    constexpr double kUnseen_px = 0.5, kSpeck_px = 0.15;
    std::vector<CurvePiece> line;
    for (CurvePiece piece : pieces) {
        if (!line.empty()) {
            const Vec2 end = line.back().curve.p3;
            const double gap = glm::distance(end, piece.curve.p0);
            if (gap >= kUnseen_px) line.push_back({line_cubic(end, piece.curve.p0), true, 0});
            if (gap > 0 && gap < kUnseen_px) start_at(piece, end);
            const bool is_speck =
                piece.straight && glm::distance(piece.curve.p0, piece.curve.p3) < kSpeck_px;
            if (is_speck) continue;
        }
        line.push_back(piece);
    }
    return line;
}

bool turns_back(const CurvePiece& in, const CurvePiece& out) {
    return glm::dot(end_direction(in.curve), start_direction(out.curve)) < kMostReversal;
}

// The parts of a stroke between places where it turns back.
std::vector<ViewStroke> without_reversals(ViewStroke&& stroke) {
    std::vector<CurvePiece>& pieces = stroke.pieces;
    std::vector<std::size_t> cuts;
    for (std::size_t i = stroke.closed ? 0 : 1; i < pieces.size(); ++i) {
        if (turns_back(pieces[(i + pieces.size() - 1) % pieces.size()], pieces[i]))
            cuts.push_back(i);
    }
    std::vector<ViewStroke> parts;
    if (cuts.empty()) {
        parts.push_back(std::move(stroke));
        return parts;
    }
    if (stroke.closed) {
        const auto first = static_cast<std::ptrdiff_t>(cuts[0]);
        std::rotate(pieces.begin(), pieces.begin() + first, pieces.end());
        for (std::size_t& cut : cuts)
            cut -= static_cast<std::size_t>(first);
        cuts.erase(cuts.begin());
    }
    cuts.push_back(pieces.size());
    std::size_t begin = 0;
    for (const std::size_t end : cuts) {
        const auto at = [&](std::size_t i) {
            return pieces.begin() + static_cast<std::ptrdiff_t>(i);
        };
        // Ends at a tip lie on the neighbouring part.
        parts.push_back({{at(begin), at(end)}, stroke.kind, false, true});
        begin = end;
    }
    if (!stroke.closed) {
        parts.front().joined = parts.back().joined = stroke.joined;
    }
    return parts;
}

class Chainer {
  public:
    Chainer(const FlatPicture& picture, const FlattenParams& params, bool hidden)
        : picture_(picture), params_(params), graph_(picture.graph), arcs_(graph_.arcs) {
        wanted_.resize(arcs_.arcs.size());
        for (std::uint32_t a = 0; a < wanted_.size(); ++a) {
            const std::uint32_t kind = graph_.kind(a);
            const LineKind line = line_of_kind(kind);
            wanted_[a] = !graph_.vanished[a] && line < LineKind::tone &&
                         is_hidden_kind(kind) == hidden && width_mm(params, line) > 0;
        }
    }

    std::vector<ViewStroke> chain() {
        spokes_ = spokes_of(graph_, wanted_, kWindow_px * picture_.map.steps_per_px);
        partner_.assign(2 * arcs_.arcs.size(), kNone);
        visit_nodes(spokes_, [&](std::span<const Spoke> spokes) { pair(spokes); });
        for (int round = 0; round < 2; ++round)
            lengthen();
        bridge();
        return collect();
    }

  private:
    static constexpr double kWindow_px = 2;
    static constexpr double kWidestGap_px = 3;

    LineKind line_of(std::uint32_t arc) const { return line_of_kind(graph_.kind(arc)); }

    // HUGE_VAL: not allowed.
    double cost(const Spoke& a, const Spoke& b) const {
        const double turn = 1 + glm::dot(a.direction, b.direction);
        if (turn > kMostTurn) return HUGE_VAL;
        const CurveSpan s = picture_.curves.span(a.use()), t = picture_.curves.span(b.use());
        const bool one_run = s.run == t.run && s.from == t.from;
        return turn + (a.kind != b.kind ? kOtherKind : 0) - (one_run ? kSameRun : 0);
    }

    bool fits(const Spoke& a, const Spoke& b) const {
        return family(line_of_kind(a.kind)) == family(line_of_kind(b.kind));
    }

    void link(std::uint32_t a, std::uint32_t b) {
        partner_[a] = b;
        partner_[b] = a;
    }

    // The cheapest pairs first.
    void pair(std::span<const Spoke> spokes) {
        struct Pair {
            double cost;
            std::uint32_t a, b;
        };
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < spokes.size(); ++i) {
            for (std::size_t j = i + 1; j < spokes.size(); ++j) {
                const double c = cost(spokes[i], spokes[j]);
                if (c < HUGE_VAL && fits(spokes[i], spokes[j]))
                    pairs.push_back({c, spokes[i].end, spokes[j].end});
            }
        }
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
        for (const Pair& p : pairs) {
            if (partner_[p.a] == kNone && partner_[p.b] == kNone) link(p.a, p.b);
        }
    }

    bool is_straight(std::uint32_t arc) const {
        const CurveSpan span = picture_.curves.span_of[arc];
        const std::vector<CurvePiece>& pieces = picture_.curves.runs[span.run].pieces;
        const double low = std::min(span.from, span.to), high = std::max(span.from, span.to);
        const auto first = static_cast<std::size_t>(low);
        return high <= static_cast<double>(first) + 1 && first < pieces.size() &&
               pieces[first].straight;
    }

    // How many ends of its chain an arc's end is away from a free one: 1 if this arc is the last.
    bool is_last(std::uint32_t end) const { return partner_[end ^ 1U] == kNone; }

    // Arcs that would be a stroke of two points take a neighbour at one of their nodes: a free end
    // of any kind, or an end out of a longer stroke of which enough is left.
    void lengthen() {
        visit_nodes(spokes_, [&](std::span<const Spoke> spokes) {
            for (const Spoke& spoke : spokes) {
                const std::uint32_t arc = spoke.end / 2;
                if (partner_[spoke.end] != kNone || partner_[spoke.end ^ 1U] != kNone) continue;
                if (is_straight(arc)) lengthen(spoke, spokes);
            }
        });
    }

    void lengthen(const Spoke& spoke, std::span<const Spoke> spokes) {
        const Spoke* best = nullptr;
        double least = HUGE_VAL;
        for (const Spoke& other : spokes) {
            if (other.end / 2 == spoke.end / 2) continue;
            double c = cost(spoke, other);
            if (!fits(spoke, other)) c += 0.5;
            const std::uint32_t partner = partner_[other.end];
            if (partner != kNone) {
                // What is cut off must not be such an arc itself.
                if (partner / 2 == other.end / 2 || !fits(spoke, other)) continue;
                if (is_last(partner) && is_straight(partner / 2)) continue;
                c += 1;
            }
            if (c < least) least = c, best = &other;
        }
        if (best == nullptr) return;
        if (partner_[best->end] != kNone) partner_[partner_[best->end]] = kNone;
        link(spoke.end, best->end);
    }

    // Where a mesh's contour has teeth, pieces of it hide behind others: lines go on over gaps that
    // are no wider than a line, straight ahead.
    void bridge() {
        std::vector<LooseEnd> ends;
        visit_nodes(spokes_, [&](std::span<const Spoke> spokes) {
            if (spokes.size() == 1 && partner_[spokes[0].end] == kNone)
                ends.push_back({place_of(spokes[0].use()), &spokes[0]});
        });
        std::sort(ends.begin(), ends.end(), [](const LooseEnd& a, const LooseEnd& b) {
            return a.at.x != b.at.x ? a.at.x < b.at.x : a.spoke->end < b.spoke->end;
        });
        struct Gap {
            double cost;
            std::uint32_t a, b;
        };
        std::vector<Gap> gaps;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                if (ends[j].at.x - ends[i].at.x > kWidestGap_px) break;
                const double c = gap_cost(ends[i], ends[j]);
                if (c < HUGE_VAL) gaps.push_back({c, ends[i].spoke->end, ends[j].spoke->end});
            }
        }
        std::stable_sort(gaps.begin(), gaps.end(),
                         [](const Gap& a, const Gap& b) { return a.cost < b.cost; });
        for (const Gap& gap : gaps) {
            if (partner_[gap.a] == kNone && partner_[gap.b] == kNone) link(gap.a, gap.b);
        }
    }

    struct LooseEnd {
        Vec2 at{0};
        const Spoke* spoke = nullptr;
    };

    Vec2 place_of(ArcUse use) const {
        const CurveSpan span = picture_.curves.span(use);
        const std::vector<CurvePiece> pieces = pieces_along(picture_.curves, {&span, 1});
        return pieces.empty() ? Vec2(HUGE_VAL) : pieces.front().curve.p0;
    }

    double gap_cost(const LooseEnd& a, const LooseEnd& b) const {
        const Vec2 gap = b.at - a.at;
        const double width = glm::length(gap);
        const double turn = 1 + glm::dot(a.spoke->direction, b.spoke->direction);
        const bool same_arc = a.spoke->end / 2 == b.spoke->end / 2;
        if (!(width <= kWidestGap_px) || turn > 0.3 || same_arc || !fits(*a.spoke, *b.spoke))
            return HUGE_VAL;
        // Not back beside themselves, by more than what a curve takes up.
        if (glm::dot(gap, a.spoke->direction) > 0.5 || glm::dot(gap, b.spoke->direction) < -0.5)
            return HUGE_VAL;
        return width + turn;
    }

    std::vector<ViewStroke> collect() const {
        const RunSet chains = follow_partners(arcs_, partner_, wanted_);
        std::vector<std::uint32_t> degree(picture_.map.map.nodes.size(), 0);
        for (const Spoke& spoke : spokes_)
            ++degree[spoke.node];
        std::vector<ViewStroke> all(chains.runs.size());
        for_each_index(all.size(), 256, [&](std::size_t i) {
            const Run& run = chains.runs[i];
            all[i] = stroke_of(chains.of(run), run.closed);
            if (run.closed) return;
            all[i].joined = degree[graph_.start_node(chains.of(run).front())] > 1 &&
                            degree[graph_.end_node(chains.of(run).back())] > 1;
        });
        std::vector<ViewStroke> strokes;
        for (ViewStroke& chain : all) {
            for (ViewStroke& stroke : without_reversals(std::move(chain))) {
                if (length_mm(stroke) >= shortest_mm(stroke)) strokes.push_back(std::move(stroke));
            }
        }
        return strokes;
    }

    // What lies between two lines is covered by their round ends if it is no longer than wide.
    double shortest_mm(const ViewStroke& stroke) const {
        if (!stroke.joined) return params_.min_line_mm;
        return std::min(params_.min_line_mm, width_mm(params_, stroke.kind));
    }

    ViewStroke stroke_of(std::span<const ArcUse> uses, bool closed) const {
        std::vector<CurveSpan> spans;
        std::array<double, 8> share{};
        for (const ArcUse& use : uses) {
            spans.push_back(picture_.curves.span(use));
            share[static_cast<std::size_t>(line_of(use.arc))] += graph_.length(use.arc);
        }
        ViewStroke stroke;
        stroke.pieces = tied(pieces_along(picture_.curves, spans));
        stroke.closed = closed;
        stroke.kind =
            static_cast<LineKind>(std::max_element(share.begin(), share.end()) - share.begin());
        return stroke;
    }

    // Within a few hundredths: the mean of chords and control polygons.
    double length_mm(const ViewStroke& stroke) const {
        double sum = 0;
        for (const CurvePiece& piece : stroke.pieces) {
            const Cubic& c = piece.curve;
            const double chord = glm::distance(c.p0, c.p3);
            sum += piece.straight ? chord
                                  : 0.5 * (chord + glm::distance(c.p0, c.p1) +
                                           glm::distance(c.p1, c.p2) + glm::distance(c.p2, c.p3));
        }
        return sum * picture_.mm_per_px;
    }

    const FlatPicture& picture_;
    const FlattenParams& params_;
    const ArcGraph& graph_;
    const ArcSet& arcs_;
    std::vector<std::uint8_t> wanted_;  // an arc
    std::vector<Spoke> spokes_;
    std::vector<std::uint32_t> partner_;  // an arc's end
};

// Draws strokes as layers: groups by kind, thin ones below.
class StrokePainter {
  public:
    StrokePainter(const FlatPicture& picture, const FlattenParams& params, const FlattenInks& inks)
        : picture_(picture), params_(params), inks_(inks) {}

    Layer paint(const std::vector<ViewStroke>& strokes) const {
        std::vector<Shape> shapes(strokes.size());
        for_each_index(strokes.size(), 256,
                       [&](std::size_t i) { shapes[i] = shape_of(strokes[i]); });
        Layer layer{"Lines", {Ink::none(), inks_.line}, {}};
        for (const KindName& kind : kKinds) {
            Group group{kind.name, {{}, {}, width_mm(params_, kind.kind)}, {}};
            for (std::size_t i = 0; i < strokes.size(); ++i) {
                if (strokes[i].kind == kind.kind && shapes[i].path.verbs.size() > 1)
                    group.children.emplace_back(std::move(shapes[i]));
            }
            if (!group.children.empty()) layer.children.emplace_back(std::move(group));
        }
        return layer;
    }

    // What lies behind: thin and dashed.
    Layer paint_hidden(const std::vector<ViewStroke>& strokes) const {
        Layer layer{"Hidden lines", {Ink::none(), inks_.hidden, kHiddenWidth_mm, kDash_mm}, {}};
        for (const ViewStroke& stroke : strokes) {
            Shape shape = plain(stroke);
            if (shape.path.verbs.size() > 1) layer.children.emplace_back(std::move(shape));
        }
        return layer;
    }

  private:
    struct KindName {
        LineKind kind;
        const char* name;
    };
    static constexpr KindName kKinds[] = {{LineKind::intersection, "Intersections"},
                                          {LineKind::crease, "Creases"},
                                          {LineKind::border, "Borders"},
                                          {LineKind::contour, "Contours"},
                                          {LineKind::silhouette, "Silhouette"}};
    static constexpr double kHiddenWidth_mm = 0.15;
    static constexpr double kDash_mm = 0.9;

    Shape plain(const ViewStroke& stroke) const {
        Shape shape;
        append_pieces(shape.path, stroke.pieces, picture_.page_from_px);
        if (stroke.closed && !shape.path.empty()) shape.path.close();
        return shape;
    }

    Shape shape_of(const ViewStroke& stroke) const {
        if (params_.taper_mm <= 0 || stroke.closed) return plain(stroke);
        const TaperParams taper{width_mm(params_, stroke.kind) / picture_.mm_per_px,
                                params_.taper_mm / picture_.mm_per_px};
        Shape shape;
        shape.path = tapered(stroke.pieces, taper, picture_.page_from_px);
        shape.paint.fill = inks_.line;
        shape.paint.stroke = Ink::none();
        return shape;
    }

    const FlatPicture& picture_;
    const FlattenParams& params_;
    const FlattenInks& inks_;
};

}  // namespace

double width_mm(const FlattenParams& params, LineKind kind) {
    switch (kind) {
        case LineKind::silhouette:
            return params.silhouette_mm;
        case LineKind::contour:
            return params.contour_mm;
        case LineKind::border:
            return params.border_mm;
        case LineKind::crease:
        case LineKind::intersection:
            return params.crease_mm;
        default:
            return 0;
    }
}

std::vector<ViewStroke> chain_strokes(const FlatPicture& picture, const FlattenParams& params,
                                      bool hidden) {
    return Chainer(picture, params, hidden).chain();
}

Layer draw_lines(const FlatPicture& picture, const FlattenParams& params, const FlattenInks& inks) {
    return StrokePainter(picture, params, inks)
        .paint(drop_covered(chain_strokes(picture, params, false), params, picture.mm_per_px));
}

Layer draw_hidden_lines(const FlatPicture& picture, const FlattenParams& params,
                        const FlattenInks& inks) {
    return StrokePainter(picture, params, inks).paint_hidden(chain_strokes(picture, params, true));
}

}  // namespace edaha
