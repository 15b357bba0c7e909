// SPDX-License-Identifier: MIT
#include "flatten/flatten.h"

#include <algorithm>
#include <utility>

#include "flatten/bark_layer.h"
#include "flatten/bark_strokes.h"
#include "flatten/draw_flat.h"
#include "flatten/make_map.h"

namespace edaha {
namespace {

FlatPlace place_of(const View& view, const FlattenParams& params) {
    FlatPlace place;
    place.mm_per_px = params.mm_per_unit > 0
                          ? params.mm_per_unit * kStepsPerPx / view.steps_per_unit
                          : params.size_mm / params.resolution;
    place.origin_mm = view.origin * (-place.mm_per_px / kStepsPerPx);
    return place;
}

FlatFrame frame_of(const View& view, const FlatPlace& place) {
    return {view.steps_per_unit * place.mm_per_px / kStepsPerPx,
            view.right,
            view.up,
            view.to_eye,
            view.middle,
            view.distance};
}

}  // namespace

Flattened flatten(const Mesh& mesh, const FlattenParams& params, const FlattenInks& inks,
                  const BarkTile& bark_tile) {
    Flattened result;
    if (mesh.triangles.empty()) return result;
    StepClock clock;
    SeenMesh seen = see_mesh(mesh, params, clock);
    const FlatPlace place = place_of(seen.view, params);
    result.frame = frame_of(seen.view, place);
    const Scene scene{mesh, seen.view, seen.tones, seen.rays};
    Layer bark;
    if (!bark_tile.empty()) {
        const std::vector<TileStroke> traced = trace_tile(scene, bark_tile, params, place);
        bark = draw_tile_bark(traced, mesh, params, inks, place);
        clock.end_step("bark", traced.size(), "strokes");
    } else if (params.bark_mm > 0) {
        bark = draw_bark(scene, params, inks, place);
        clock.end_step("bark", bark.children.size(), "strokes");
    }
    result.layers = draw_flat(std::move(seen.map), mesh.parts, params, inks, place, clock);
    // Over the fills, under the lines.
    if (!bark.children.empty()) {
        const auto lines = std::find_if(result.layers.begin(), result.layers.end(),
                                        [](const Layer& layer) { return layer.label != "Fills"; });
        result.layers.insert(lines, std::move(bark));
    }
    result.steps = clock.take();
    return result;
}

}  // namespace edaha
