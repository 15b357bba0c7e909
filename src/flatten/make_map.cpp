// SPDX-License-Identifier: MIT
#include "flatten/make_map.h"

#include <utility>

#include "flatten/intersections.h"
#include "flatten/label_map.h"
#include "flatten/segments.h"
#include "geometry/snap_round.h"

namespace edaha {
namespace {

void append(std::vector<ViewSegment>& segments, std::vector<ViewSegment> more) {
    segments.insert(segments.end(), more.begin(), more.end());
}

Arrangement arrange(std::span<const ViewSegment> segments) {
    std::vector<GridSegment> flat;
    flat.reserve(segments.size());
    for (const ViewSegment& s : segments)
        flat.push_back({on_screen(s.a), on_screen(s.b)});
    return snap_round(flat);
}

}  // namespace

SeenMesh see_mesh(const Mesh& mesh, const FlattenParams& params, StepClock& clock) {
    View view = project(mesh, params.camera, params.resolution);
    clock.end_step("project", view.at.size(), "points");
    const std::vector<MeshEdge> edges = mesh_edges(mesh);
    view.shown = find_shown(mesh, edges, view);
    std::vector<ViewSegment> segments = edge_segments(mesh, edges, view, params.crease_rad);
    clock.end_step("edges", segments.size(), "segments");
    Crossings crossings = intersect_shown(view, mesh);
    append(segments, std::move(crossings.segments));
    clock.end_step("intersections", segments.size(), "segments");
    ToneField tones = make_tones(mesh, edges, view, params);
    append(segments, tone_segments(mesh, edges, view, tones));
    clock.end_step("tones", segments.size(), "segments");

    const Arrangement arrangement = arrange(segments);
    clock.end_step("snap", arrangement.edges.size(), "edges");
    LabelledMap map;
    map.steps_per_px = kStepsPerPx;
    map.map = build_planar_map(arrangement.nodes, arrangement.edges);
    clock.end_step("map", map.map.faces(), "faces");

    RayScene rays(view, mesh, std::move(crossings.flush));
    clock.end_step("ray scene", mesh.triangles.size(), "triangles");
    const Scene scene{mesh, view, tones, rays};
    label_faces(map, scene);
    clock.end_step("label faces", map.map.faces(), "rays");
    label_edges(map, scene, arrangement, segments, params.look == FlatLook::blueprint);
    clock.end_step("label edges", map.line.size(), "edges");
    return {std::move(view), std::move(tones), std::move(rays), std::move(map)};
}

}  // namespace edaha
