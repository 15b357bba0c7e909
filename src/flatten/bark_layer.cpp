// SPDX-License-Identifier: MIT
#include "flatten/bark_layer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/range.h"
#include "drawing/palette.h"
#include "flatten/bark_crossings.h"
#include "flatten/taper.h"

namespace edaha {
namespace {

// How obliquely a surface may be seen: below the first nothing is drawn, above the second all.
constexpr Range kFacing{0.06, 0.22};
// Over how much of the demand a stroke swells from nothing to its width: less, and ends are blunt;
// more, and all strokes are thin.
constexpr double kSwell = 0.16;
constexpr double kStep_px = 2;
constexpr int kSmoothing = 4;  // steps to both sides
// Thinner ends are left out.
constexpr double kThinnest = 0.12;
constexpr double kShortest_px = 5;
constexpr double kThinnestTwig_mm = 1.6;

double smooth_step(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

struct TileTrace {
    const Scene& scene;
    const BarkTile& tile;
    const FlattenParams& params;
    double px_per_mm = 1;
    std::vector<PartCover> covers;
    double spacing_px = 1;  // of the tile's strokes, seen straight
};

double mean_spacing_mm(const BarkTile& tile) {
    double length = 0;
    for (const BarkLine& line : tile.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i)
            length += glm::distance(line.points[i - 1], line.points[i]);
    }
    return length > 0 ? tile.width_mm * tile.height_mm / length : 0;
}

// What is known at a place of a stroke.
struct StrokePlace {
    Vec2 at{0};
    double width = 0;   // px, without thinning
    double demand = 0;  // ranks below this are drawn
};

class StrokeMaker {
  public:
    StrokeMaker(const TileTrace& trace, const BarkWay& way)
        : trace_(trace),
          way_(way),
          cover_(trace.covers[way.front().part]),
          laid_(cover_.lines[way.front().line]),
          line_(trace.tile.lines[laid_.line]) {}

    void run(std::vector<TileStroke>& found) {
        std::vector<SurfaceStep> steps;
        double most = 0;
        for (const BarkPiece& piece : way_) {
            steps.push_back(piece.step);
            most = std::max({most, demand_at(piece, 0), demand_at(piece, 1)});
        }
        if (most <= laid_.rank) return;
        for (const SeenStretch& stretch : seen_stretches(trace_.scene.rays, steps))
            thin_out(stretch, found);
    }

  private:
    double demand_at(const BarkPiece& piece, double t) const {
        const double crowd = crowd_demand(trace_.spacing_px, cover_.squeeze, piece.room);
        const double facing =
            smooth_step((piece.facing - kFacing.low) / (kFacing.high - kFacing.low));
        return std::min(1.0, crowd) * facing *
               tone_demand(piece.bright_from + (piece.bright_to - piece.bright_from) * t);
    }

    double tone_demand(double bright) const {
        if (trace_.scene.tones.at.empty()) return 1;
        const FlattenParams& p = trace_.params;
        const double range = p.shine - p.shade;
        double light = range > 0 ? smooth_step((bright - p.shade) / (1.15 * range)) : 0.5;
        if (line_.light) light = 1 - light;
        return 1 - p.bark_shade * light;
    }

    StrokePlace place(const SeenPlace& seen) const {
        const BarkPiece& piece = way_[seen.step];
        const double t = piece.start + (piece.end - piece.start) * seen.t;
        const auto i = std::min(static_cast<std::size_t>(t), line_.widths_mm.size() - 1);
        const double next = line_.widths_mm[std::min(i + 1, line_.widths_mm.size() - 1)];
        const double width = line_.widths_mm[i] + (next - line_.widths_mm[i]) * (t - double(i));
        StrokePlace result;
        result.at = seen.at / double(kStepsPerPx);
        result.width = width * trace_.px_per_mm * trace_.params.bark_scale *
                       trace_.params.bark_width *
                       std::clamp(double(piece.room) * std::min(1.0, cover_.squeeze), 0.35, 1.3);
        result.demand = demand_at(piece, seen.t);
        return result;
    }

    // At even distances.
    std::vector<StrokePlace> evened(const SeenStretch& stretch) const {
        std::vector<StrokePlace> rough{place(stretch.front())};
        std::vector<double> passed{0};
        for (std::size_t i = 1; i < stretch.size(); ++i) {
            const StrokePlace next = place(stretch[i]);
            const double way = glm::distance(next.at, rough.back().at);
            if (!(way > 1e-6)) continue;
            passed.push_back(passed.back() + way);
            rough.push_back(next);
        }
        const int count = std::max(2, static_cast<int>(std::ceil(passed.back() / kStep_px)));
        std::vector<StrokePlace> even;
        std::size_t i = 1;
        for (int k = 0; k <= count && rough.size() > 1; ++k) {
            const double wanted = passed.back() * k / count;
            while (i + 1 < rough.size() && passed[i] < wanted)
                ++i;
            const double t = (wanted - passed[i - 1]) / (passed[i] - passed[i - 1]);
            const StrokePlace &a = rough[i - 1], &b = rough[i];
            even.push_back({a.at + (b.at - a.at) * t, a.width + (b.width - a.width) * t,
                            a.demand + (b.demand - a.demand) * t});
        }
        return even;
    }

    // Triangle by triangle, demand jumps.
    static void smooth(std::vector<StrokePlace>& places) {
        for (int round = 0; round < 2; ++round) {
            const std::vector<StrokePlace> old = places;
            for (std::size_t i = 0; i < places.size(); ++i) {
                const std::size_t reach =
                    std::min({i, places.size() - 1 - i, std::size_t{kSmoothing}});
                double demand = 0, width = 0;
                for (std::size_t k = i - reach; k <= i + reach; ++k)
                    demand += old[k].demand, width += old[k].width;
                places[i].demand = demand / double(2 * reach + 1);
                places[i].width = width / double(2 * reach + 1);
            }
        }
    }

    void thin_out(const SeenStretch& stretch, std::vector<TileStroke>& found) const {
        std::vector<StrokePlace> places = evened(stretch);
        if (places.size() < 2) return;
        smooth(places);
        TileStroke stroke{way_.front().part, line_.light, {}, {}};
        const double step = glm::distance(places[0].at, places[1].at);
        const auto end = [&] {
            const double length = step * double(stroke.points.size());
            if (stroke.points.size() > 2 && length >= shortest_px()) found.push_back(stroke);
            stroke.points.clear();
            stroke.widths_px.clear();
        };
        for (const StrokePlace& p : places) {
            const double share = smooth_step((p.demand - laid_.rank) / kSwell);
            if (share < kThinnest) {
                end();
                continue;
            }
            stroke.points.push_back(p.at);
            stroke.widths_px.push_back(p.width * share);
        }
        end();
    }

    double shortest_px() const {
        return std::max(kShortest_px, 2 * trace_.params.min_line_mm * trace_.px_per_mm);
    }

    const TileTrace& trace_;
    const BarkWay& way_;
    const PartCover& cover_;
    const LaidLine& laid_;
    const BarkLine& line_;
};

Colour ink_of(const TileStroke& stroke, const Mesh& mesh, const FlattenInks& inks) {
    if (!stroke.light) return inks.line;
    const std::uint32_t material = mesh.parts[stroke.part].material;
    if (material >= inks.tones.size() || inks.tones[material].empty()) return inks.paper;
    return mixed(inks.tones[material].back(), inks.paper, 0.35);
}

Path outline(const TileStroke& stroke, const FlattenParams& params, const FlatPlace& place) {
    SmoothParams smooth;
    smooth.tolerance = std::max(0.3, params.smoothing_px);
    const std::vector<CurvePiece> line = smooth_line(stroke.points, false, smooth);
    const double widest = *std::max_element(stroke.widths_px.begin(), stroke.widths_px.end());
    if (!(widest > 0)) return {};
    std::vector<double> shares;
    for (const double width : stroke.widths_px)
        shares.push_back(width / widest);
    TaperParams taper;
    taper.width_px = widest;
    taper.taper_px = std::min(0.3 * kStep_px * double(stroke.points.size()), 7 * widest);
    taper.widths = shares;
    taper.tolerance_px = 0.2;
    const double s = place.mm_per_px;
    return tapered(line, taper, Affine(s, 0, 0, s, place.origin_mm.x, place.origin_mm.y));
}

}  // namespace

std::vector<TileStroke> trace_tile(const Scene& scene, const BarkTile& tile,
                                   const FlattenParams& params, const FlatPlace& place) {
    const double px_per_unit = scene.view.steps_per_unit / kStepsPerPx;
    TileTrace trace{scene, tile, params, 1 / place.mm_per_px, {}, 1};
    const double units_per_mm = trace.px_per_mm / px_per_unit;
    trace.spacing_px = mean_spacing_mm(tile) * params.bark_scale * trace.px_per_mm;
    trace.covers = lay_bark(
        scene.mesh, scene.view, tile,
        {units_per_mm * params.bark_scale, units_per_mm * kThinnestTwig_mm, trace.spacing_px});
    const std::vector<BarkWay> ways = cross_bark(scene, trace.covers, px_per_unit);
    return gather_chunks<TileStroke>(ways.size(), 64,
                                     [&](std::size_t i, std::vector<TileStroke>& found) {
                                         StrokeMaker(trace, ways[i]).run(found);
                                     });
}

Layer draw_tile_bark(const std::vector<TileStroke>& strokes, const Mesh& mesh,
                     const FlattenParams& params, const FlattenInks& inks, const FlatPlace& place) {
    Layer layer{"Bark", {inks.line, Ink::none()}, {}};
    std::vector<Path> paths(strokes.size());
    for_each_index(strokes.size(), 256,
                   [&](std::size_t i) { paths[i] = outline(strokes[i], params, place); });
    for (std::size_t i = 0, end = 0; i < strokes.size(); i = end) {
        while (end < strokes.size() && strokes[end].part == strokes[i].part)
            ++end;
        Group group{mesh.parts[strokes[i].part].name + "-bark", {}, {}};
        for (const bool light : {true, false}) {
            for (std::size_t k = i; k < end; ++k) {
                if (strokes[k].light != light || paths[k].empty()) continue;
                Shape shape{"", std::move(paths[k]), {}};
                if (light) shape.paint.fill = ink_of(strokes[k], mesh, inks);
                group.children.emplace_back(std::move(shape));
            }
        }
        if (!group.children.empty()) layer.children.emplace_back(std::move(group));
    }
    return layer;
}

}  // namespace edaha
