// SPDX-License-Identifier: MIT
#include "geometry/nest_loops.h"

#include <numeric>

#include "geometry/cell_grid.h"

namespace edaha {
namespace {

// Edges by the cells that they are near.
struct EdgeCells {
    CellGrid grid;
    std::vector<std::uint32_t> first, edges;
};

EdgeCells sort_edges_into_cells(const PlanarMap& map) {
    GridBox box;
    for (const GridPoint p : map.nodes)
        box.include(p);
    EdgeCells cells;
    double length = 0;
    const auto segment = [&](const Edge& e) {
        return GridSegment{map.nodes[e.from], map.nodes[e.to]};
    };
    for (const Edge& e : map.edges) {
        length += static_cast<double>(segment(e).b.x - segment(e).a.x);
    }
    const double count = static_cast<double>(map.edges.size());
    cells.grid = make_cell_grid(box, map.edges.size(), length / count / 4);
    cells.first.assign(cells.grid.cells() + 2, 0);
    for (const Edge& e : map.edges) {
        cells.grid.visit_cells(segment(e), [&](std::size_t cell) { ++cells.first[cell + 2]; });
    }
    std::partial_sum(cells.first.begin(), cells.first.end(), cells.first.begin());
    cells.edges.resize(cells.first.back());
    for (std::uint32_t i = 0; i < map.edges.size(); ++i) {
        cells.grid.visit_cells(segment(map.edges[i]),
                               [&](std::size_t cell) { cells.edges[cells.first[cell + 1]++] = i; });
    }
    return cells;
}

// Whether s lies above t just right of x, which both reach over; ends are ordered by x.
bool is_above(const GridSegment& s, const GridSegment& t, std::int32_t x) {
    const GridVector d = s.b - s.a, e = t.b - t.a;
    const Int128 height = (Int128{s.a.y} * d.x + Int128{d.y} * (x - s.a.x)) * e.x;
    const Int128 other = (Int128{t.a.y} * e.x + Int128{e.y} * (x - t.a.x)) * d.x;
    return height != other ? height > other : cross(e, d) > 0;
}

// Looks down from a component's smallest node along the line just right of it. The component's
// own edges are not in the way: none lies left of that node or straight below it.
class Lookout {
  public:
    explicit Lookout(const PlanarMap& map) : map_(map), cells_(sort_edges_into_cells(map)) {}

    std::uint32_t loop_below(std::uint32_t node) {
        const GridPoint eye = map_.nodes[node];
        const CellGrid& grid = cells_.grid;
        const std::int64_t column = grid.column(eye.x);
        std::uint32_t nearest = kNone;
        for (std::int64_t row = grid.row(eye.y); row >= 0 && nearest == kNone; --row) {
            const std::size_t cell = grid.cell(column, row);
            const std::int64_t floor = grid.origin.y + row * grid.size;
            for (std::uint32_t i = cells_.first[cell]; i < cells_.first[cell + 1]; ++i) {
                consider(cells_.edges[i], eye, floor, nearest);
            }
        }
        // Edges run from smaller to larger nodes: left to right, with the space above to the left.
        return nearest == kNone ? kNone : map_.loop_of[2 * nearest];
    }

  private:
    // An edge that leaves the cell below its floor is left for the cells below: one of theirs may
    // be nearer there.
    void consider(std::uint32_t edge, GridPoint eye, std::int64_t floor, std::uint32_t& nearest) {
        const GridSegment s = segment(edge);
        if (s.a.x > eye.x || s.b.x <= eye.x || orientation(s.a, s.b, eye) <= 0) return;
        const GridPoint ground{eye.x, static_cast<std::int32_t>(floor)};
        if (orientation(s.a, s.b, ground) > 0) return;
        if (nearest == kNone || is_above(s, segment(nearest), eye.x)) nearest = edge;
    }

    GridSegment segment(std::uint32_t edge) const {
        return {map_.nodes[map_.edges[edge].from], map_.nodes[map_.edges[edge].to]};
    }

    const PlanarMap& map_;
    EdgeCells cells_;
};

}  // namespace

std::vector<std::uint32_t> loops_below(const PlanarMap& map,
                                       std::span<const std::uint32_t> hole_loops) {
    std::vector<std::uint32_t> below;
    if (hole_loops.size() == 1) return {kNone};  // one component: nothing is around it
    if (hole_loops.empty()) return below;
    Lookout lookout(map);
    below.reserve(hole_loops.size());
    for (const std::uint32_t loop : hole_loops) {
        below.push_back(lookout.loop_below(map.origin(map.loops[loop].first)));
    }
    return below;
}

}  // namespace edaha
