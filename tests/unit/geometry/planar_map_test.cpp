// SPDX-License-Identifier: MIT
#include "geometry/planar_map.h"

#include <gtest/gtest.h>

#include "map_oracles.h"

namespace edaha {
namespace {

using Segments = std::vector<GridSegment>;

void add_box(Segments& segments, int x0, int y0, int x1, int y1) {
    const GridPoint p[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    for (int i = 0; i < 4; ++i)
        segments.push_back({p[i], p[(i + 1) % 4]});
}

TEST(PlanarMap, OfNothingIsOneFace) {
    const PlanarMap map = build_planar_map({}, {});
    EXPECT_EQ(map.faces(), 1u);
    EXPECT_TRUE(map.loops_of(0).empty());
}

TEST(PlanarMap, ASquareGridHasItsSquares) {
    Segments lines;
    for (int i = 0; i <= 8; ++i) {
        lines.push_back({{0, 10 * i}, {80, 10 * i}});
        lines.push_back({{10 * i, 0}, {10 * i, 80}});
    }
    const PlanarMap map = oracles::map_of(lines);
    ASSERT_EQ(map.faces(), 65u);
    for (std::uint32_t face = 1; face < 65; ++face)
        EXPECT_EQ(face_area(map, face), 100);
}

TEST(PlanarMap, NestedBoxesNestTheirFaces) {
    Segments boxes;
    for (int i = 0; i < 5; ++i)
        add_box(boxes, 10 * i, 10 * i, 200 - 10 * i, 200 - 10 * i);
    const PlanarMap map = oracles::map_of(boxes);
    ASSERT_EQ(map.faces(), 6u);
    for (int i = 0; i < 5; ++i) {
        const double outer = 200 - 20 * i, inner = i == 4 ? 0 : outer - 20;
        const std::uint32_t face = oracles::face_at(map, {100.5, 10 * i + 5.0});
        EXPECT_EQ(face_area(map, face), outer * outer - inner * inner);
        EXPECT_EQ(map.loops_of(face).size(), i == 4 ? 1u : 2u);
    }
}

TEST(PlanarMap, ADanglingEdgeBordersOneFaceTwice) {
    Segments segments;
    add_box(segments, 0, 0, 10, 10);
    segments.push_back({{0, 0}, {5, 5}});
    segments.push_back({{2, 7}, {3, 8}});  // and one that floats inside
    const PlanarMap map = oracles::map_of(segments);
    ASSERT_EQ(map.faces(), 2u);
    EXPECT_EQ(face_area(map, 1), 100);
    EXPECT_EQ(map.loops_of(1).size(), 2u);
}

TEST(PlanarMap, ComponentsAboveANodeBelongToItsOuterFace) {
    // The lower box's left side ends right below the upper one's smallest node.
    Segments segments;
    add_box(segments, 0, 0, 10, 10);
    add_box(segments, 0, 20, 10, 30);
    add_box(segments, 10, 40, 20, 50);
    const PlanarMap map = oracles::map_of(segments);
    EXPECT_EQ(map.loops_of(0).size(), 3u);
}

// What holds of every map, judged edge by edge: hole loops lie in the face left of their smallest
// node, faces round their interior points.
void expect_faces_in_place(const PlanarMap& map) {
    for (const PlanarMap::Loop& loop : map.loops) {
        if (loop.area > 0) continue;
        const Vec2 node = to_vec(map.nodes[map.origin(loop.first)]);
        EXPECT_EQ(oracles::face_at(map, node - Vec2(1e-7, 0)), loop.face);
    }
    for (std::uint32_t face = 1; face < map.faces(); ++face) {
        EXPECT_GT(face_area(map, face), 0);
        EXPECT_EQ(oracles::face_at(map, interior_point(map, face) + Vec2(1e-9, 0)), face);
    }
}

TEST(PlanarMap, FacesOfRandomSoupsAreWhereTheyAre) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        // Many short segments: hundreds of components inside each other's faces.
        Segments soup = oracles::random_soup(60, 400, seed);
        for (const GridSegment& s : oracles::random_soup(300, 400, seed + 100)) {
            const GridVector d = s.b - s.a;
            const GridPoint end{s.a.x + static_cast<int>(d.x) / 20,
                                s.a.y + static_cast<int>(d.y) / 20};
            soup.push_back({s.a, end});
        }
        expect_faces_in_place(oracles::map_of(soup));
    }
}

TEST(PlanarMap, FacesBelowSlantingEdgesAreFound) {
    // Slivers that run steeply past hundreds of triangles: the next edge below a triangle is often
    // not in the cell where the first sliver is met.
    shapes::Random random;
    Segments segments;
    const auto at = [&](int side) { return static_cast<std::int32_t>(random() * side); };
    const auto add_triangle = [&](GridPoint a, GridPoint b, GridPoint c) {
        segments.insert(segments.end(), {{a, b}, {b, c}, {c, a}});
    };
    for (int i = 0; i < 40; ++i) {
        const GridPoint foot{at(4000), at(1000)};
        add_triangle(foot, {foot.x + 40, foot.y}, {foot.x + 700 + at(200), foot.y + 3000});
    }
    for (int i = 0; i < 600; ++i) {
        const GridPoint p{at(5000), at(4000)};
        add_triangle(p, {p.x + 9, p.y + 2}, {p.x + 5, p.y + 11});
    }
    expect_faces_in_place(oracles::map_of(segments));
}

}  // namespace
}  // namespace edaha
