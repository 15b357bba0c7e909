// SPDX-License-Identifier: MIT
#include "flatten/segments.h"

#include <optional>

#include "base/parallel.h"
#include "mesh/facets.h"

namespace edaha {
namespace {

class EdgeJudge {
  public:
    EdgeJudge(const Mesh& mesh, const View& view, double crease_rad)
        : mesh_(mesh), view_(view), crease_(crease_rad) {}

    std::optional<ViewSegment> judge(const MeshEdge& edge) const {
        const bool left = is_shown(edge.left), right = is_shown(edge.right);
        if (!left && !right) return std::nullopt;
        const LineKind kind = kind_of(edge, left && right);
        if (kind == LineKind::none) return std::nullopt;
        // Of a contour's triangles the front one.
        const bool first = left && (!right || view_.front[edge.left] != 0);
        const std::uint32_t shown = first ? edge.left : edge.right;
        const bool alone = kind == LineKind::contour || !left || !right;
        const std::uint32_t other = alone ? kNone : first ? edge.right : edge.left;
        ViewSegment segment{view_.at[edge.a], view_.at[edge.b], shown, other, kind};
        if (on_screen(segment.a) == on_screen(segment.b)) return std::nullopt;
        return segment;
    }

  private:
    bool is_shown(std::uint32_t triangle) const {
        return triangle != kNone && view_.shown[triangle] != 0;
    }

    LineKind kind_of(const MeshEdge& edge, bool both_shown) const {
        if (edge.left == kNone || edge.right == kNone) return LineKind::border;
        if (!both_shown || view_.front[edge.left] != view_.front[edge.right])
            return LineKind::contour;
        if (mesh_.part_of[edge.left] != mesh_.part_of[edge.right]) return LineKind::border;
        return crease_.is_sharp(mesh_, edge) ? LineKind::crease : LineKind::none;
    }

    const Mesh& mesh_;
    const View& view_;
    FacetAngle crease_;
};

}  // namespace

std::vector<ViewSegment> edge_segments(const Mesh& mesh, std::span<const MeshEdge> edges,
                                       const View& view, double crease_rad) {
    const EdgeJudge judge(mesh, view, crease_rad);
    return gather<ViewSegment>(edges.size(), [&](std::size_t i, auto& found) {
        if (const auto segment = judge.judge(edges[i])) found.push_back(*segment);
    });
}

}  // namespace edaha
