// SPDX-License-Identifier: MIT
#include "flatten/draw_flat.h"

#include <utility>

#include "flatten/absorb.h"
#include "flatten/arc_curves.h"
#include "flatten/fills.h"
#include "flatten/kept_edges.h"
#include "flatten/strokes.h"

namespace edaha {
namespace {

// Arcs shorter than this don't show: longer, and corners of small areas would be seen to move.
constexpr double kShortestArc_px = 0.4;
// Over which it is judged which arcs go on smoothly: as for corners (smooth_line.cpp).
constexpr double kWindow_px = 2;

FitParams fit_params(const LabelledMap& map, const SeenRegions& regions,
                     const FlattenParams& params) {
    FitParams fit;
    fit.steps_per_px = map.steps_per_px;
    fit.width = regions.width;
    fit.smooth.tolerance = params.smoothing_px;
    fit.smooth.noise = 0.15;
    fit.smooth.straight = params.look == FlatLook::facets || params.smoothing_px <= 0;
    return fit;
}

std::size_t count_children(const Layer& layer) {
    std::size_t count = 0;
    for (const Element& element : layer.children)
        count += std::get<Group>(element).children.size();
    return count;
}

}  // namespace

std::vector<Layer> draw_flat(LabelledMap map, std::span<const MeshPart> parts,
                             const FlattenParams& params, const FlattenInks& inks,
                             const FlatPlace& place, StepClock& clock) {
    map = absorb_small_regions(std::move(map), params.min_area_px2);
    if (params.look != FlatLook::fills) {
        map = erase_crowded_lines(std::move(map), params.min_area_px2,
                                  params.crease_mm / place.mm_per_px);
    }
    const SeenRegions regions = find_regions(map);
    clock.end_step("absorb", regions.rings.rings.size(), "rings");
    const std::vector<std::uint32_t> kinds = kept_edges(map, params.look);
    std::vector<std::uint8_t> is_outer(map.map.faces());
    for (std::size_t face = 0; face < is_outer.size(); ++face)
        is_outer[face] = map.labels[face].part == kNone;
    const ArcGraph graph =
        make_arc_graph(map.map, kinds, {kShortestArc_px * map.steps_per_px, is_outer});
    const RunSet runs = join_arcs(graph, {kWindow_px * map.steps_per_px, 25});
    clock.end_step("arcs", graph.arcs.arcs.size(), "arcs");
    const ArcCurves curves = fit_arcs(graph, runs, fit_params(map, regions, params));
    clock.end_step("curves", curves.runs.size(), "curves");
    const double scale = place.mm_per_px;
    const Affine page_from_px(scale, 0, 0, scale, place.origin_mm.x, place.origin_mm.y);
    const FlatPicture picture{map, regions, graph, curves, parts, page_from_px, scale};
    std::vector<Layer> layers;
    const bool filled = params.look != FlatLook::lines && params.look != FlatLook::blueprint;
    if (filled) {
        layers.push_back(draw_fills(picture, params, inks));
        clock.end_step("fills", layers.back().children.size(), "parts");
    }
    if (params.look == FlatLook::blueprint)
        layers.push_back(draw_hidden_lines(picture, params, inks));
    if (params.look != FlatLook::fills) {
        layers.push_back(draw_lines(picture, params, inks));
        clock.end_step("lines", count_children(layers.back()), "lines");
    }
    return layers;
}

}  // namespace edaha
