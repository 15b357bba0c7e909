// SPDX-License-Identifier: MIT
#include "ornament/sprig_clumps.h"

#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace edaha {
namespace {

using glm::dvec3;

// A full cube of points about a middle.
void add_cube(std::vector<dvec3>& points, const dvec3& middle) {
    for (int i = 0; i < 125; ++i)
        points.push_back(middle + dvec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2));
}

TEST(SprigClumps, HeapsApartAreAClumpEach) {
    std::vector<dvec3> points;
    const std::vector<dvec3> heaps{{0, 0, 0}, {30, 0, 0}, {0, 40, 0}, {0, 0, -50}};
    for (const dvec3& heap : heaps)
        add_cube(points, heap);
    const Clumps clumps = find_clumps(points, 10);
    ASSERT_EQ(clumps.middles.size(), heaps.size());
    std::set<std::uint32_t> seen;
    for (std::size_t heap = 0; heap < heaps.size(); ++heap) {
        const std::uint32_t clump = clumps.of_point[125 * heap];
        seen.insert(clump);
        EXPECT_LT(glm::distance(clumps.middles[clump], heaps[heap]), 1e-9);
        for (std::size_t i = 0; i < 125; ++i)
            EXPECT_EQ(clumps.of_point[125 * heap + i], clump);
        // The root mean square distance in a cube of five is sqrt(6).
        EXPECT_NEAR(clumps.radii[clump], std::sqrt(10), 1e-9);
    }
    EXPECT_EQ(seen.size(), heaps.size());
}

TEST(SprigClumps, AWideRadiusMakesOneOfAll) {
    std::vector<dvec3> points;
    add_cube(points, {1, 2, 3});
    const Clumps clumps = find_clumps(points, 1e9);
    ASSERT_EQ(clumps.middles.size(), 1U);
    EXPECT_LT(glm::distance(clumps.middles[0], dvec3(1, 2, 3)), 1e-9);
}

TEST(SprigClumps, NothingMakesNone) {
    EXPECT_TRUE(find_clumps({}, 1).middles.empty());
}

RC_GTEST_PROP(SprigClumps, EachPointBelongsToTheNearestMiddle, ()) {
    const auto numbers = *rc::gen::container<std::vector<int>>(60, rc::gen::inRange(-50, 50));
    std::vector<dvec3> points;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    const Clumps clumps = find_clumps(points, *rc::gen::inRange(1, 60));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double own = glm::distance(points[i], clumps.middles[clumps.of_point[i]]);
        for (const dvec3& middle : clumps.middles)
            RC_ASSERT(own <= glm::distance(points[i], middle) + 1e-9);
    }
}

}  // namespace
}  // namespace edaha
