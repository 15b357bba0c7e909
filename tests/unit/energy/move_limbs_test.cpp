// SPDX-License-Identifier: MIT
#include "energy/move_limbs.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "energy/grow.h"

namespace edaha {
namespace {

TEST(MoveLimbs, TurnsATreeAboutItsFoot) {
    EnergyParams params;
    params.growth.energy = 40;
    const LookParams look;
    const Limbs before = make_limbs(grow(params), params, look);
    const double turn = 0.3;
    const Limbs after = moved_limbs(before, {{70, -20}, turn});
    ASSERT_EQ(after.nodes.size(), before.nodes.size());
    EXPECT_EQ(after.nodes[0].position, Vec2(70, -20));
    for (std::size_t i = 0; i < after.nodes.size(); ++i) {
        const LimbNode &a = after.nodes[i], &b = before.nodes[i];
        EXPECT_NEAR(glm::distance(a.position, Vec2(70, -20)), glm::length(b.position), 1e-9);
        EXPECT_NEAR(glm::length(a.velocity), glm::length(b.velocity), 1e-12);
        // Its angle to the way from the foot is kept.
        EXPECT_NEAR(glm::dot(a.velocity, a.position - Vec2(70, -20)),
                    glm::dot(b.velocity, b.position), 1e-9);
        EXPECT_EQ(a.half_width, b.half_width);
    }
}

TEST(MoveLimbs, ScalesLengthsAndWidths) {
    EnergyParams params;
    params.growth.energy = 40;
    const Limbs before = make_limbs(grow(params), params, LookParams{});
    const Limbs after = moved_limbs(before, {{0, 0}, 0, 3});
    for (std::size_t i = 0; i < after.nodes.size(); ++i) {
        const LimbNode &a = after.nodes[i], &b = before.nodes[i];
        EXPECT_NEAR(glm::distance(a.position, b.position * 3.0), 0, 1e-12);
        EXPECT_DOUBLE_EQ(a.half_width, 3 * b.half_width);
        EXPECT_DOUBLE_EQ(a.chord, 3 * b.chord);
        EXPECT_EQ(a.taper, b.taper);  // of the width over the length
    }
}

TEST(MoveLimbs, TurnsToTheRight) {
    Limbs limbs;
    limbs.nodes = {{{0, 0}, {0, -1}}, {{0, -10}, {0, -1}}};  // y down: straight up
    const Limbs turned = moved_limbs(limbs, {{0, 0}, std::acos(0.0)});
    EXPECT_NEAR(turned.nodes[1].position.x, 10, 1e-12);
    EXPECT_NEAR(turned.nodes[1].position.y, 0, 1e-12);
    EXPECT_NEAR(turned.nodes[1].velocity.x, 1, 1e-12);
}

}  // namespace
}  // namespace edaha
