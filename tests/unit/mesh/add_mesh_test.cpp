// SPDX-License-Identifier: MIT
#include "mesh/add_mesh.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "mesh/mesh_check.h"
#include "shapes.h"

namespace edaha {
namespace {

TEST(TurnFromUp, IsTheLeastRotation) {
    for (const Vec3 way : {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 2, -3),
                           Vec3(-2, -5, 0.1), Vec3(1e-9, -1, 0)}) {
        const Vec3 direction = glm::normalize(way);
        const glm::dmat3 turn = turn_from_up(direction);
        EXPECT_NEAR(glm::distance(turn * Vec3(0, 1, 0), direction), 0, 1e-8);
        EXPECT_NEAR(glm::determinant(turn), 1, 1e-8);
        const Vec3 axis(direction.z, 0, -direction.x);  // which it keeps
        EXPECT_NEAR(glm::distance(turn * axis, axis), 0, 1e-8);
    }
}

TEST(AddMesh, KeepsPartsApartAndMovesAll) {
    Mesh mesh = test::box();
    Mesh more = test::box(Vec3(-1, 0, -1), Vec3(1, 2, 1));
    more.parts[0].axis = Axis{Vec3(0), Vec3(0, 2, 0)};
    more.sites.push_back({Vec3(0, 2, 0), Vec3(0, 1, 0), 3, 0});
    MeshPlace place;
    place.turn = turn_from_up(Vec3(1, 0, 0));
    place.scale = 10;
    place.shift = Vec3(5, 6, 7);
    add_mesh(mesh, more, place);
    EXPECT_TRUE(validate(mesh).sound());
    EXPECT_EQ(validate(mesh).pieces, 2U);
    EXPECT_NEAR(test::volume6(mesh), 6 * (1 + 8 * 1000), 1e-6);
    EXPECT_NEAR(glm::distance(mesh.sites[0].position, Vec3(25, 6, 7)), 0, 1e-12);
    EXPECT_NEAR(glm::distance(mesh.sites[0].direction, Vec3(1, 0, 0)), 0, 1e-12);
    EXPECT_EQ(mesh.sites[0].size, 30);
    EXPECT_EQ(mesh.sites[0].part, 1U);
    EXPECT_NEAR(glm::distance(mesh.parts[1].axis->to, Vec3(25, 6, 7)), 0, 1e-12);
    EXPECT_EQ(mesh.materials[mesh.parts[1].material].name, "wood");
}

TEST(AddMesh, FillsUpPlacesInUv) {
    Mesh mesh = test::box(), more = test::box();
    more.uv.resize(12, {glm::dvec2(1), glm::dvec2(1), glm::dvec2(1)});
    add_mesh(mesh, more, {});
    add_mesh(mesh, test::box(), {});
    ASSERT_EQ(mesh.uv.size(), 36U);
    EXPECT_EQ(mesh.uv[11][0], glm::dvec2(0));
    EXPECT_EQ(mesh.uv[12][0], glm::dvec2(1));
    EXPECT_EQ(mesh.uv[24][0], glm::dvec2(0));
}

}  // namespace
}  // namespace edaha
