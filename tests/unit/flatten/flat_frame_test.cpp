// SPDX-License-Identifier: MIT
#include "flatten/flat_frame.h"

#include <gtest/gtest.h>

#include "flatten/flatten.h"
#include "geometry/bounds.h"

namespace edaha {
namespace {

// A tetrahedron away from the origin.
Mesh tetrahedron() {
    Mesh mesh;
    mesh.points = {{1, 2, 0}, {5, 2, 1}, {2, 7, -1}, {3, 3, 4}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    mesh.part_of = {0, 0, 0, 0};
    mesh.parts = {{"part", 0, -1, 0, std::nullopt}};
    mesh.materials = {{"wood", std::nullopt}};
    return mesh;
}

void include(Bounds& box, const std::vector<Element>& elements) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) box.include(bounds(shape->path));
        if (const auto* group = std::get_if<Group>(&element)) include(box, group->children);
    }
}

void expect_where_the_frame_says(const FlattenParams& params) {
    const Mesh mesh = tetrahedron();
    FlattenInks inks;
    inks.tones = {{Colour{}, Colour{}, Colour{}}};
    const Flattened flat = flatten(mesh, params, inks);
    Bounds drawn, expected;
    for (const Layer& layer : flat.layers)
        include(drawn, layer.children);
    for (const Vec3& point : mesh.points)
        expected.include(flat.frame.flat_from_world(point));
    ASSERT_FALSE(drawn.empty());
    EXPECT_NEAR(drawn.min.x, expected.min.x, 0.05);
    EXPECT_NEAR(drawn.min.y, expected.min.y, 0.05);
    EXPECT_NEAR(drawn.max.x, expected.max.x, 0.05);
    EXPECT_NEAR(drawn.max.y, expected.max.y, 0.05);
    EXPECT_EQ(flat.frame.flat_from_world({0, 0, 0}), Vec2(0, 0));
}

TEST(FlatFrame, SaysWhereThingsAreDrawn) {
    FlattenParams params;
    params.look = FlatLook::fills;
    params.size_mm = 100;
    params.trap_mm = 0;
    expect_where_the_frame_says(params);
    params.camera.azimuth_rad = 0.7;
    params.camera.elevation_rad = 0.4;
    expect_where_the_frame_says(params);
    params.mm_per_unit = 30;
    expect_where_the_frame_says(params);
    params.camera.projection = Projection::perspective;
    expect_where_the_frame_says(params);
}

TEST(FlatFrame, NearThingsAreLarger) {
    FlatFrame frame;
    frame.mm_per_unit = 2;
    EXPECT_EQ(frame.mm_per_unit_at({3, 4, 5}), 2);
    frame.distance = 10;
    EXPECT_EQ(frame.mm_per_unit_at({3, 4, 0}), 2);
    EXPECT_EQ(frame.mm_per_unit_at({3, 4, 5}), 4);
    EXPECT_EQ(frame.flat_from_world({1, 0, 5}), Vec2(4, 0));
    EXPECT_EQ(frame.flat_from_world({0, 1, -10}), Vec2(0, -1));
}

}  // namespace
}  // namespace edaha
