// SPDX-License-Identifier: MIT
#include "prism/growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "base/error.h"
#include "solids.h"

namespace edaha {
namespace {

KeyedRandom random_of(std::uint64_t seed) {
    return {1, seed, 1};
}

PrismParams only(double PrismParams::*weight) {
    PrismParams params;
    params.straight = params.two_way = params.mixed = 0;
    params.*weight = 1;
    return params;
}

const Prism& parent_of(const GrownPrisms& tree, const Prism& prism) {
    return tree.prisms[static_cast<std::size_t>(prism.parent)];
}

TEST(PrismGrowth, OnlyStraightIsOneColumn) {
    PrismParams params = only(&PrismParams::straight);
    params.depth = 9;
    const GrownPrisms tree = grow(params, random_of(1));
    ASSERT_EQ(tree.prisms.size(), 9U);
    double height = 0;
    for (std::size_t n = 1; n <= 9; ++n) {
        const Prism& prism = tree.prisms[n - 1];
        EXPECT_NEAR(prism.length, params.length_mm / static_cast<double>(n), 1e-12);
        EXPECT_LT(glm::distance(prism.origin, Vec3(0, height, 0)), 1e-12);
        EXPECT_EQ(prism.direction(), Vec3(0, 1, 0));
        EXPECT_EQ(prism.depth, n);
        height += params.length_mm / static_cast<double>(n);
    }
}

TEST(PrismGrowth, OnlyTwoWayDoublesAtEachDepth) {
    PrismParams params = only(&PrismParams::two_way);
    params.depth = 10;
    const GrownPrisms tree = grow(params, random_of(1));
    std::vector<std::size_t> by_depth(11);
    for (const Prism& prism : tree.prisms)
        ++by_depth[prism.depth];
    for (std::size_t n = 1; n <= 10; ++n)
        EXPECT_EQ(by_depth[n], std::size_t{1} << (n - 1));
}

TEST(PrismGrowth, TwoWayHalvesShareOutTheirParentsArea) {
    PrismParams params = only(&PrismParams::two_way);
    params.cut_spread = 0.9;
    params.radius_spread = 0.8;
    const GrownPrisms tree = grow(params, random_of(3));
    std::vector<double> shared(tree.prisms.size(), 0);
    for (const Prism& prism : tree.prisms) {
        if (prism.parent >= 0) shared[static_cast<std::size_t>(prism.parent)] += area(prism.base);
    }
    for (std::size_t i = 0; i < shared.size(); ++i) {
        if (tree.prisms[i].last) continue;
        EXPECT_NEAR(shared[i] / area(tree.prisms[i].base), 1, 1e-9);
    }
}

TEST(PrismGrowth, MixedHasTheMainAndOneOrBothHalves) {
    PrismParams params = only(&PrismParams::mixed);
    const auto children = [&](double both) {
        params.both = both;
        const GrownPrisms tree = grow(params, random_of(1));
        std::vector<std::vector<int>> result(tree.prisms.size());
        for (const Prism& prism : tree.prisms) {
            if (prism.parent >= 0)
                result[static_cast<std::size_t>(prism.parent)].push_back(prism.child);
        }
        std::erase_if(result, [](const auto& list) { return list.empty(); });
        return result;
    };
    for (const auto& list : children(1))
        EXPECT_EQ(list, (std::vector<int>{0, 1, 2}));
    std::size_t first = 0, forks = 0;
    for (const auto& list : children(0)) {
        ASSERT_EQ(list.size(), 2U);
        EXPECT_EQ(list[0], 0);
        first += list[1] == 1 ? 1 : 0;
        ++forks;
    }
    EXPECT_GT(first, 0U);
    EXPECT_LT(first, forks);
}

// How often each case was taken: straight on, two-way, mixed.
std::array<double, 3> cases_in(const GrownPrisms& tree) {
    std::vector<std::array<int, 2>> mains_and_halves(tree.prisms.size());
    for (const Prism& prism : tree.prisms) {
        if (prism.parent < 0) continue;
        ++mains_and_halves[static_cast<std::size_t>(prism.parent)][prism.child == 0 ? 0 : 1];
    }
    std::array<double, 3> cases{};
    for (std::size_t i = 0; i < tree.prisms.size(); ++i) {
        const auto [mains, halves] = mains_and_halves[i];
        if (!tree.prisms[i].last) ++cases[mains == 0 ? 1 : halves == 0 ? 0 : 2];
    }
    return cases;
}

TEST(PrismGrowth, WeightsAreShares) {
    PrismParams params;
    params.straight = 2, params.two_way = 1, params.mixed = 1;
    std::array<double, 3> cases{};
    double all = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const auto more = cases_in(grow(params, random_of(seed)));
        for (std::size_t i = 0; i < 3; ++i)
            cases[i] += more[i], all += more[i];
    }
    ASSERT_GT(all, 600);
    const double most = 2.5 / std::sqrt(all);  // five standard deviations of one half
    EXPECT_NEAR(cases[0] / all, 0.5, most);
    EXPECT_NEAR(cases[1] / all, 0.25, most);
    EXPECT_NEAR(cases[2] / all, 0.25, most);
}

TEST(PrismGrowth, BasesStandOnTheirParentsTops) {
    PrismParams params;
    params.depth = 8;
    params.taper = 0.9;
    params.radius_spread = 0.5;
    const GrownPrisms tree = grow(params, random_of(4));
    ASSERT_GT(tree.prisms.size(), 20U);
    for (const Prism& prism : tree.prisms) {
        EXPECT_LT(glm::length(centroid(prism.base)), 1e-9);
        if (prism.parent < 0) continue;
        const PrismCorners& c = parent_of(tree, prism).corners;
        const Vec3 normal = glm::cross(c[4] - c[3], c[5] - c[3]);
        EXPECT_NEAR(glm::dot(prism.origin - c[3], glm::normalize(normal)), 0, 1e-9);
        for (std::size_t i = 3; i < 6; ++i) {  // inside, not only in its plane
            const Vec3 side = c[i == 5 ? 3 : i + 1] - c[i];
            EXPECT_GT(glm::dot(glm::cross(side, prism.origin - c[i]), normal), 0);
        }
    }
}

// GA = alpha ga' + (1 - alpha) g turns by atan(alpha / (1 - alpha)).
TEST(PrismGrowth, AlphaAndBetaSayHowFarHalvesTurn) {
    PrismParams params = only(&PrismParams::two_way);
    params.alpha = {0.3, 0.3};
    params.beta = {0.5, 0.5};
    for (const PrismFrame frame : {PrismFrame::paper, PrismFrame::parallel}) {
        params.frame = frame;
        const GrownPrisms tree = grow(params, random_of(1));
        for (const Prism& prism : tree.prisms) {
            if (prism.parent < 0) continue;
            const double cosine = glm::dot(prism.direction(), parent_of(tree, prism).direction());
            const double expected = prism.child == 1 ? std::atan(3.0 / 7) : std::atan(1.0);
            EXPECT_NEAR(std::acos(cosine), expected, 1e-9);
        }
    }
}

TEST(PrismGrowth, MitredJointsLeaveNoGap) {
    PrismParams params = only(&PrismParams::two_way);
    params.alpha = params.beta = {0.1, 0.4};
    params.joint = PrismJoint::mitre;
    params.frame = PrismFrame::parallel;
    const GrownPrisms tree = grow(params, random_of(1));
    for (const Prism& prism : tree.prisms) {
        if (prism.parent < 0) continue;
        const Prism& parent = parent_of(tree, prism);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LT(glm::dot(prism.corners[i] - parent.tip(), parent.direction()), 1e-9);
            // A side stays where it was: only longer.
            const PrismCorners open = open_corners(prism);
            const Vec3 side = glm::normalize(open[i + 3] - open[i]);
            EXPECT_LT(glm::length(glm::cross(open[i] - prism.corners[i], side)), 1e-9);
        }
    }
}

TEST(PrismGrowth, WeldedBasesMakeUpTheirParentsTop) {
    PrismParams params = only(&PrismParams::two_way);
    params.alpha = params.beta = {0.1, 0.6};
    params.joint = PrismJoint::weld;
    params.frame = PrismFrame::parallel;
    params.taper = 0.8;
    const GrownPrisms tree = grow(params, random_of(1));
    std::vector<double> covered(tree.prisms.size(), 0);
    for (const Prism& prism : tree.prisms) {
        if (prism.parent < 0) continue;
        const PrismCorners& c = prism.corners;
        const PrismCorners& top = parent_of(tree, prism).corners;
        const auto in_top = [&](std::size_t i) {
            return std::ranges::any_of(
                top, [&](const Vec3& corner) { return glm::distance(c[i], corner) < 1e-9; });
        };
        EXPECT_EQ(in_top(0) + in_top(1) + in_top(2), 2);  // the third is where the cut ends
        covered[static_cast<std::size_t>(prism.parent)] +=
            glm::length(glm::cross(c[1] - c[0], c[2] - c[0])) / 2;
    }
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const Prism& prism = tree.prisms[i];
        if (prism.last) continue;
        EXPECT_NEAR(covered[i] / (area(prism.base) * 0.8 * 0.8), 1, 1e-9);
    }
}

// The widest overlap of two prisms of a tree that don't meet at a joint, in mm.
double widest_overlap(const std::vector<Prism>& prisms) {
    double widest = 0;
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (std::cmp_equal(prisms[i].parent, j) || prisms[i].parent == prisms[j].parent)
                continue;
            widest = std::max(widest, -oracles::gap(prisms[i].corners, prisms[j].corners));
        }
    }
    return widest;
}

TEST(PrismGrowth, NoTwoPrismsPassThroughEachOther) {
    PrismParams params;
    params.depth = 8;
    params.mixed = 2;
    params.radius_mm = 3;
    std::size_t turned = 0, dropped = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        params.interference = false;
        EXPECT_GT(widest_overlap(grow(params, random_of(seed)).prisms), 0.1);
        params.interference = true;
        for (const PrismJoint joint : {PrismJoint::open, PrismJoint::mitre, PrismJoint::weld}) {
            params.joint = joint;
            const GrownPrisms tree = grow(params, random_of(seed));
            EXPECT_LT(widest_overlap(tree.prisms), 1e-3);
            turned += tree.turned, dropped += tree.dropped;
        }
    }
    EXPECT_GT(turned, 0U);
    EXPECT_GT(dropped, 0U);
}

TEST(PrismGrowth, TurningFindsRoomForMore) {
    PrismParams params;
    params.depth = 9;
    params.interference = true;
    std::size_t dropped[2] = {};
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        params.tries = 0;
        dropped[0] += grow(params, random_of(seed)).dropped;
        params.tries = 8;
        dropped[1] += grow(params, random_of(seed)).dropped;
    }
    EXPECT_LT(dropped[1], dropped[0]);
}

TEST(PrismGrowth, TheBoleGoesStraightOn) {
    PrismParams params = only(&PrismParams::two_way);
    params.bole = 3;
    std::vector<std::size_t> by_depth(8);
    params.depth = 7;
    for (const Prism& prism : grow(params, random_of(1)).prisms)
        ++by_depth[prism.depth];
    EXPECT_EQ(by_depth, (std::vector<std::size_t>{0, 1, 1, 1, 1, 2, 4, 8}));
}

TEST(PrismGrowth, WanderingStaysWithinItsAngle) {
    PrismParams params = only(&PrismParams::straight);
    params.depth = 300;
    params.length_power = 0;
    params.wander_rad = 0.2;
    const GrownPrisms tree = grow(params, random_of(1));
    double most = 0;
    for (const Prism& prism : tree.prisms) {
        if (prism.parent < 0) continue;
        const double cosine = glm::dot(prism.direction(), parent_of(tree, prism).direction());
        most = std::max(most, std::acos(cosine));
    }
    EXPECT_LE(most, 0.2 + 1e-9);
    EXPECT_GT(most, 0.19);
}

TEST(PrismGrowth, LiftDrawsBranchesUpAndDown) {
    PrismParams params = only(&PrismParams::two_way);
    const auto mean_rise = [&](double lift) {
        params.lift = lift;
        double sum = 0;
        const auto prisms = grow(params, random_of(1)).prisms;
        for (const Prism& prism : prisms)
            sum += prism.direction().y;
        return sum / static_cast<double>(prisms.size());
    };
    EXPECT_LT(mean_rise(-0.3), mean_rise(0) - 0.1);
    EXPECT_GT(mean_rise(0.3), mean_rise(0) + 0.1);
}

TEST(PrismGrowth, NothingEndsBelowTheGround) {
    PrismParams params = only(&PrismParams::two_way);
    params.lift = -0.5;
    params.interference = true;
    const auto lowest = [&] {
        double low = 1e9;
        for (const Prism& prism : grow(params, random_of(1)).prisms)
            low = std::min(low, prism.tip().y);
        return low;
    };
    EXPECT_LT(lowest(), 50);
    params.ground_mm = 50;
    EXPECT_GE(lowest(), 50);
}

TEST(PrismGrowth, LengthsStayWithinTheirSpread) {
    PrismParams params = only(&PrismParams::two_way);
    params.depth = 9;
    params.length_spread = 0.2;
    double least = 2, most = 0;
    for (const Prism& prism : grow(params, random_of(1)).prisms) {
        const double factor = prism.length * prism.depth / params.length_mm;
        least = std::min(least, factor), most = std::max(most, factor);
    }
    EXPECT_GE(least, 0.8 - 1e-9);
    EXPECT_LE(most, 1.2 + 1e-9);
    EXPECT_LT(least, 0.85);
    EXPECT_GT(most, 1.15);
}

TEST(PrismGrowth, MembersOfAFamilyAreAlike) {
    PrismParams params;
    params.depth = 8;
    const auto tips = [&](std::uint64_t seed, double vary) {
        std::vector<Vec3> result;
        for (const Prism& prism : grow(params, KeyedRandom(7, seed, vary)).prisms)
            result.push_back(prism.tip());
        return result;
    };
    EXPECT_EQ(tips(1, 0), tips(2, 0));
    EXPECT_EQ(tips(1, 1), tips(1, 1));
    EXPECT_NE(tips(1, 1), tips(2, 1));
    EXPECT_NE(tips(1, 0.3), tips(2, 0.3));
}

template <class Call>
std::string error_of(const Call& call) {
    try {
        call();
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

TEST(PrismGrowth, RefusesWhatItCannotGrow) {
    PrismParams params = only(&PrismParams::two_way);
    params.depth = 60;
    params.limit = 1000;
    const auto run = [&] { grow(params, random_of(1)); };
    EXPECT_EQ(
        error_of(run),
        "prism.limit: the tree has more than 1000 prisms; lower prism.depth or raise the limit");
    params.two_way = 0;
    EXPECT_EQ(error_of(run), "prism.straight, two-way, mixed: one of them must be above 0");
    params = only(&PrismParams::straight);
    params.side_a_mm = 9, params.side_b_mm = 3, params.side_c_mm = 4;
    EXPECT_EQ(error_of(run), "prism.side-a, side-b, side-c: no triangle has these sides");
    params.side_a_mm = 0;
    EXPECT_EQ(error_of(run), "prism.side-a, side-b, side-c: no triangle has these sides");
    params.side_a_mm = 5;
    EXPECT_NEAR(area(grow(params, random_of(1)).prisms[0].base), 6, 1e-9);
}

}  // namespace
}  // namespace edaha
