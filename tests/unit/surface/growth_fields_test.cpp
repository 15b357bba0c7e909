// SPDX-License-Identifier: MIT
#include "surface/growth_fields.h"

#include <gtest/gtest.h>

#include "surface/move.h"
#include "unit/surface/grown.h"

namespace edaha {
namespace {

// What touches an obstacle does so under its new number, though vertices have come meanwhile and
// that is higher than any was.
TEST(GrowthFields, KnowsWhatTouchesByItsNewNumber) {
    SurfaceParams params = trunk(60);
    params.thickening_mm = 8;
    SolidParams rod;
    rod.from = {-2000, 1400, 300};
    rod.to = {2000, 1400, 300};
    params.obstacles.push_back(rod);
    const SurfaceGrowth growth = grown(params);
    GrowingMesh mesh = growth.mesh();
    const std::vector<Vec3> normals = vertex_normals(mesh, face_normals(mesh));
    GrowthFields fields(params, KeyedRandom(1, 1, 1));
    fields.begin(growth.steps(), mesh, growth.apices(), normals);
    std::vector<Vec3> moves = fields.moves(mesh, growth.apices(), normals);
    fields.stop_at_obstacles(mesh, moves);
    const std::size_t touching = fields.contacts();
    ASSERT_GT(touching, 3U);
    const auto count = static_cast<std::uint32_t>(mesh.position.size());
    std::vector<std::uint32_t> number(std::size_t{2} * count, kNone);
    for (std::uint32_t v = 0; v < count; ++v)
        number[v] = count + v;
    fields.renumber(number);
    EXPECT_EQ(fields.contacts(), touching);
}

}  // namespace
}  // namespace edaha
