// SPDX-License-Identifier: MIT
#include "flatten/label_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 500;

FaceLabel label_of(const Scene& scene, const RayScene::Hit& hit) {
    FaceLabel label{scene.mesh.part_of[hit.triangle], 0};
    if (scene.tones.at.empty() || !scene.view.front[hit.triangle]) return label;
    const std::array<float, 3>& at = scene.tones.at[hit.triangle];
    label.tone =
        scene.tones.band(at[0] * hit.weights[0] + at[1] * hit.weights[1] + at[2] * hit.weights[2]);
    return label;
}

class EdgeLabeller {
  public:
    EdgeLabeller(const LabelledMap& map, const Scene& scene, const Arrangement& arrangement,
                 std::span<const ViewSegment> segments)
        : map_(map), scene_(scene), arrangement_(arrangement), segments_(segments) {}

    LineKind seen(std::uint32_t edge) const {
        const FaceLabel left = map_.labels[map_.map.face_of(2 * edge)];
        const FaceLabel right = map_.labels[map_.map.face_of(2 * edge + 1)];
        if (left.part != right.part) return between(edge, left.part, right.part);
        if (left.part == kNone) return LineKind::none;
        const LineKind kind = within(edge, left.part);
        if (kind != LineKind::none) return kind;
        return left.tone != right.tone ? LineKind::tone : LineKind::none;
    }

    LineKind hidden(std::uint32_t edge) const {
        LineKind strongest = LineKind::none;
        for (const EdgeUse& use : arrangement_.uses_of(edge)) {
            const ViewSegment& segment = segments_[use.segment];
            if (segment.kind >= std::min(strongest, LineKind::tone)) continue;
            if (is_hidden(edge, segment)) strongest = segment.kind;
        }
        return strongest;
    }

  private:
    std::uint32_t part_of(std::uint32_t triangle) const {
        return triangle == kNone ? kNone : scene_.mesh.part_of[triangle];
    }
    bool lies_on(const ViewSegment& segment, std::uint32_t part) const {
        return part_of(segment.triangle) == part || part_of(segment.other) == part;
    }

    LineKind between(std::uint32_t edge, std::uint32_t left, std::uint32_t right) const {
        if (left == kNone || right == kNone) return LineKind::silhouette;
        LineKind strongest = LineKind::border;
        for (const EdgeUse& use : arrangement_.uses_of(edge)) {
            const ViewSegment& segment = segments_[use.segment];
            if (lies_on(segment, left) || lies_on(segment, right))
                strongest = std::min(strongest, segment.kind);
        }
        return strongest;
    }

    // Contours first; they come in twos where a facet is seen edge on.
    LineKind within(std::uint32_t edge, std::uint32_t part) const {
        LineKind strongest = LineKind::none;
        int turn = 0;
        for (const EdgeUse& use : arrangement_.uses_of(edge)) {
            const ViewSegment& segment = segments_[use.segment];
            const bool is_contour = segment.kind == LineKind::contour;
            const bool is_line = segment.kind < LineKind::tone;
            if (!is_line || !lies_on(segment, part)) continue;
            if (!is_contour && segment.kind >= strongest) continue;
            if (is_hidden(edge, segment)) continue;
            if (is_contour) {
                turn += side_of(edge, segment.triangle);
            } else {
                strongest = segment.kind;
            }
        }
        return turn != 0 ? LineKind::contour : strongest;
    }

    // 1 if the triangle lies to the left of the edge, -1 if to the right.
    int side_of(std::uint32_t edge, std::uint32_t triangle) const {
        const GridPoint from = map_.map.nodes[map_.map.origin(2 * edge)];
        const GridPoint to = map_.map.nodes[map_.map.target(2 * edge)];
        std::int64_t sum = 0;
        for (const std::uint32_t point : scene_.mesh.triangles[triangle])
            sum += orientation(from, to, on_screen(scene_.view.at[point]));
        return sum > 0 ? 1 : sum < 0 ? -1 : 0;
    }

    // At the place of the segment that is nearest to the middle of the edge.
    bool is_hidden(std::uint32_t edge, const ViewSegment& segment) const {
        const PlanarMap& map = map_.map;
        const Vec2 middle = 0.5 * (to_vec(map.nodes[map.origin(2 * edge)]) +
                                   to_vec(map.nodes[map.target(2 * edge)]));
        const Vec2 a = to_vec(on_screen(segment.a)), along = to_vec(on_screen(segment.b)) - a;
        const double t = std::clamp(glm::dot(middle - a, along) / glm::dot(along, along), 0.0, 1.0);
        const double z = segment.a.z + t * (double(segment.b.z) - segment.a.z);
        return scene_.rays.is_hidden(a + t * along, z, {segment.triangle, segment.other});
    }

    const LabelledMap& map_;
    const Scene& scene_;
    const Arrangement& arrangement_;
    std::span<const ViewSegment> segments_;
};

}  // namespace

void label_faces(LabelledMap& map, const Scene& scene) {
    map.labels.assign(map.map.faces(), {});
    map.depth.assign(map.map.faces(), 0);
    for_each_index(map.map.faces() - 1, kWorthThreads, [&](std::size_t i) {
        const auto face = static_cast<std::uint32_t>(i + 1);
        const auto hit = scene.rays.look(interior_point(map.map, face));
        if (!hit) return;
        map.labels[face] = label_of(scene, *hit);
        map.depth[face] = hit->z;
    });
}

void label_edges(LabelledMap& map, const Scene& scene, const Arrangement& arrangement,
                 std::span<const ViewSegment> segments, bool with_hidden) {
    const EdgeLabeller labeller(map, scene, arrangement, segments);
    map.line.assign(map.map.edges.size(), LineKind::none);
    for_each_index(map.line.size(), kWorthThreads, [&](std::size_t i) {
        map.line[i] = labeller.seen(static_cast<std::uint32_t>(i));
    });
    if (!with_hidden) return;
    map.hidden.assign(map.map.edges.size(), LineKind::none);
    for_each_index(map.hidden.size(), kWorthThreads, [&](std::size_t i) {
        map.hidden[i] = labeller.hidden(static_cast<std::uint32_t>(i));
    });
}

}  // namespace edaha
