// SPDX-License-Identifier: MIT
#include "proproot/prop_root_mesh.h"

#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "proproot/root_line.h"
#include "unit/proproot/closed.h"

namespace edaha::test {
namespace {

PropRootParams params_of(RootType type, int primaries) {
    PropRootParams params;
    params.type = type;
    params.primaries = primaries;
    params.young = 0.1;
    return params;
}

PropRoots grown(const PropRootParams& params, std::uint64_t seed = 5) {
    return grow_prop_roots(params, KeyedRandom(1, seed, 1));
}

// The points of a root's circles, in the order in which tubes are made.
class RootCircles {
  public:
    RootCircles(const Mesh& mesh, std::size_t part, int points)
        : points_(static_cast<std::size_t>(points)) {
        std::set<std::uint32_t> used;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            if (mesh.part_of[i] == part)
                used.insert(mesh.triangles[i].begin(), mesh.triangles[i].end());
        for (const std::uint32_t index : used)
            all_.push_back(mesh.points[index]);
    }
    std::size_t count() const { return (all_.size() - 2) / points_; }
    Vec3 at(std::size_t circle, std::size_t j) const { return all_[circle * points_ + j]; }
    Vec3 centre(std::size_t circle) const {
        Vec3 sum(0);
        for (std::size_t j = 0; j < points_; ++j)
            sum += at(circle, j);
        return sum / static_cast<double>(points_);
    }

  private:
    std::size_t points_;
    std::vector<Vec3> all_;
};

// Calls check(root, circles) for each root of some plants.
template <typename Check>
void for_many_roots(const Check& check) {
    for (const RootType type : {RootType::standard, RootType::gentle, RootType::steep}) {
        const PropRootParams params = params_of(type, 22);
        const PropRoots plant = grown(params);
        const Mesh mesh = mesh_of(plant, params);
        for (std::size_t i = 0; i < plant.roots.size(); ++i)
            check(plant.roots[i], RootCircles(mesh, i + 1, params.circle_points));
    }
}

TEST(PropRootMesh, IsClosedAndFacesOutwardsPartByPart) {
    for (const RootType type : {RootType::standard, RootType::gentle, RootType::steep}) {
        const PropRootParams params = params_of(type, 49);
        const PropRoots plant = grown(params);
        const Mesh mesh = mesh_of(plant, params);
        EXPECT_TRUE(parts_are_closed(mesh));
        ASSERT_EQ(mesh.parts.size(), plant.roots.size() + 1);
        const std::vector<double> volume = volumes(mesh);
        for (std::size_t i = 0; i < plant.roots.size(); ++i) {
            const PropRoot& root = plant.roots[i];
            // A cylinder's, give or take knob, taper and tip.
            const double straight = std::numbers::pi * root.radius * root.radius * root.length;
            EXPECT_GT(volume[i + 1], 0.6 * straight) << plant.name_of(root);
            EXPECT_LT(volume[i + 1], 2.5 * straight) << plant.name_of(root);
        }
    }
}

TEST(PropRootMesh, MiddleLinesAreTheCatenariesHeights) {
    for_many_roots([](const PropRoot& root, const RootCircles& circles) {
        for (std::size_t i = root.order == 1 ? 1 : 0; i < circles.count(); ++i) {
            const Vec3 centre = circles.centre(i);
            const double x = std::hypot(centre.x - root.base.x, centre.z - root.base.z);
            EXPECT_NEAR(centre.y, root.curve.height(x), 1e-9);
            if (!root.bulges) {
                const double a = root.curve.a;  // (3.5)
                EXPECT_NEAR(centre.y, a * std::cosh(x / a) - a + root.base.y, 1e-9);
            }
        }
    });
}

TEST(PropRootMesh, RootsStandOnTheGroundOrEndInTheAir) {
    std::size_t young = 0;
    for_many_roots([&](const PropRoot& root, const RootCircles& circles) {
        const std::size_t last = circles.count() - 1;
        young += root.young;
        for (std::size_t j = 0; j < 12; ++j) {
            if (root.young) {
                EXPECT_GT(circles.at(last, j).y, 0);
            } else {
                EXPECT_EQ(circles.at(last, j).y, 0);
            }
        }
        if (root.young) return;
        for (std::size_t i = 0; i < last; ++i)
            for (std::size_t j = 0; j < 12; ++j)
                EXPECT_GT(circles.at(i, j).y, 0) << i << " of " << last;
    });
    EXPECT_GT(young, 0U);
}

// Each point of a circle lies ahead of its fellow on the one before, and beside it: no circle cuts
// into the next, nothing is wrung.
TEST(PropRootMesh, TubesAreNeitherPinchedNorTwisted) {
    for_many_roots([](const PropRoot& root, const RootCircles& circles) {
        const bool pointed = root.young;
        for (std::size_t i = 0; i + (pointed ? 2 : 1) < circles.count(); ++i) {
            const Vec3 from = circles.centre(i), to = circles.centre(i + 1);
            const Vec3 way = glm::normalize(to - from);
            for (std::size_t j = 0; j < 12; ++j) {
                EXPECT_GT(glm::dot(circles.at(i + 1, j) - circles.at(i, j), way), 0)
                    << "order " << root.order << ", circle " << i;
                const Vec3 a = circles.at(i, j) - from, b = circles.at(i + 1, j) - to;
                const Vec3 a_square = a - way * glm::dot(a, way);
                const Vec3 b_square = b - way * glm::dot(b, way);
                const double cosine =
                    glm::dot(a_square, b_square) / (glm::length(a_square) * glm::length(b_square));
                EXPECT_GT(cosine, 0.8);
            }
        }
    });
}

TEST(PropRootMesh, PartsSayWhatTheyAre) {
    const PropRootParams params = params_of(RootType::standard, 30);
    const PropRoots plant = grown(params);
    const Mesh mesh = mesh_of(plant, params);
    ASSERT_EQ(mesh.materials.size(), 2U);
    EXPECT_EQ(mesh.parts[0].name, "trunk");
    EXPECT_EQ(mesh.materials[mesh.parts[0].material].name, "trunk");
    std::set<std::string> names;
    for (std::size_t i = 1; i < mesh.parts.size(); ++i) {
        const MeshPart& part = mesh.parts[i];
        const MeshPart& parent = mesh.parts[static_cast<std::size_t>(part.parent)];
        EXPECT_EQ(mesh.materials[part.material].name, "root");
        EXPECT_EQ(part.order, parent.order + 1);
        EXPECT_TRUE(part.name.starts_with(part.order == 1 ? "root-" : parent.name + '-'));
        EXPECT_TRUE(names.insert(part.name).second);
    }
    EXPECT_TRUE(mesh.sites.empty());
    EXPECT_EQ(mesh.part_of.size(), mesh.triangles.size());
}

TEST(PropRootMesh, OrdersHaveColoursIfAsked) {
    PropRootParams params = params_of(RootType::standard, 49);
    params.order_colours = true;
    const PropRoots plant = grown(params);
    const Mesh mesh = mesh_of(plant, params);
    ASSERT_EQ(mesh.materials.size(), 6U);
    EXPECT_FALSE(mesh.materials[0].colour);
    for (std::size_t i = 0; i < plant.roots.size(); ++i) {
        EXPECT_EQ(mesh.parts[i + 1].material, plant.roots[i].order);
        EXPECT_TRUE(mesh.materials[plant.roots[i].order].colour);
    }
}

TEST(PropRootMesh, TheCrownGoesOnWhereTheTrunkEnds) {
    PropRootParams params = params_of(RootType::standard, 80);
    params.trunk_bend = 1;
    const PropRoots plant = grown(params);
    const Mesh mesh = mesh_of(plant, params);
    const TrunkTop top = trunk_top(plant);
    EXPECT_NEAR(top.position.y, plant.trunk.height, 1e-9);
    EXPECT_NEAR(glm::length(top.direction), 1, 1e-12);
    EXPECT_LT(top.radius, plant.trunk.foot_radius);
    // The rim of the trunk's upper end.
    std::size_t rim = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (mesh.part_of[i] != 0) continue;
        for (const std::uint32_t p : mesh.triangles[i]) {
            const Vec3 offset = mesh.points[p] - top.position;
            if (std::abs(glm::dot(offset, top.direction)) < 1e-9 && glm::length(offset) > 1e-9) {
                EXPECT_NEAR(glm::length(offset), top.radius, 1e-9);
                ++rim;
            }
        }
    }
    EXPECT_GT(rim, 0U);
}

// The ends of what style files may ask for.
TEST(PropRootMesh, IsSoundForExtremeParameters) {
    std::vector<PropRootParams> all(12);
    all[0].primaries = 1;
    all[1].primaries = 100;
    all[2].highest = 1;
    all[3].highest = 1000;
    all[3].type = RootType::gentle;
    all[4].bulges = 1;
    all[4].type = RootType::steep;
    all[5].young = 1;
    all[6].knob = 3;
    all[7].trunk_bend = 3;
    all[7].trunk_taper = 0.9;
    all[7].primaries = 100;
    all[8].circle_points = 3;
    all[8].curve_points = 1;
    all[9].curve_points = 256;
    all[10].max_order = 5;
    all[10].branchings = 0;
    all[11].tries = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const PropRoots plant = grown(all[i]);
        const Mesh mesh = mesh_of(plant, all[i]);
        EXPECT_TRUE(parts_are_closed(mesh)) << i;
        for (const Vec3& point : mesh.points)
            EXPECT_TRUE(std::isfinite(point.x + point.y + point.z)) << i;
        for (const double volume : volumes(mesh))
            EXPECT_GT(volume, 0) << i;
    }
}

TEST(PropRootMesh, IsAsFineAsIsAsked) {
    PropRootParams params = params_of(RootType::standard, 20);
    const PropRoots plant = grown(params);
    const std::size_t usual = mesh_of(plant, params).triangles.size();
    params.circle_points *= 2;
    EXPECT_GT(mesh_of(plant, params).triangles.size(), 1.9 * double(usual));
    params.curve_points *= 3;
    EXPECT_GT(mesh_of(plant, params).triangles.size(), 3.0 * double(usual));
}

}  // namespace
}  // namespace edaha::test
