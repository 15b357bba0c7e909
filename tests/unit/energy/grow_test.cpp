// SPDX-License-Identifier: MIT
#include "energy/grow.h"

#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/kolmogorov.h"

namespace edaha {
namespace {

EnergyParams params_of(TreeType type, double energy, std::uint64_t seed = 1) {
    EnergyParams params;
    params.growth.type = type;
    params.growth.energy = energy;
    params.variant.seed = seed;
    return params;
}

// Energy of the children, grown and dropped, by parent.
std::map<std::int32_t, double> shared_out(const Skeleton& tree) {
    std::map<std::int32_t, double> sums;
    for (const Branch& branch : tree.branches) {
        if (branch.parent >= 0) sums[branch.parent] += branch.energy;
    }
    for (const DroppedBranch& dropped : tree.dropped)
        sums[dropped.parent] += dropped.energy;
    return sums;
}

// What a fork drew, brought back to [0, 1): shares of energy and turns.
struct Draws {
    std::vector<double> shares, turns;
};

Draws draws_of(const Skeleton& tree, const EnergyParams& params) {
    Draws draws;
    for (const Branch& branch : tree.branches) {
        if (branch.parent < 0) continue;
        const Branch& parent = tree.branches[static_cast<std::size_t>(branch.parent)];
        const double share = branch.energy / parent.energy;
        const double turn = branch.heading_rad - parent.heading_rad;
        const auto place = [](double value, Range range) {
            return (value - range.low) / (range.high - range.low);
        };
        if (params.growth.type == TreeType::a) {
            if (branch.child == 0) draws.shares.push_back(place(share, params.growth.share));
            draws.turns.push_back(place(turn, params.branch.turn_rad));
        } else if (branch.child == 0) {
            draws.shares.push_back(place(share, params.growth.main_share));
            EXPECT_EQ(turn, 0);
        } else {
            draws.turns.push_back(place(turn, branch.child == 1 ? params.branch.right_turn_rad
                                                                : params.branch.left_turn_rad));
        }
    }
    return draws;
}

double identity(double u) {
    return u;
}

}  // namespace

class GrowBothTypes : public testing::TestWithParam<TreeType> {};
INSTANTIATE_TEST_SUITE_P(Types, GrowBothTypes, testing::Values(TreeType::a, TreeType::b));

TEST_P(GrowBothTypes, EnergyIsConservedAtEveryFork) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        EnergyParams params = params_of(GetParam(), 500, seed);
        params.space.candidates = 6;
        params.space.drop = seed % 2 == 0 ? 0.6 : 0;
        params.growth.order = seed % 3 == 0 ? GrowthOrder::energy : GrowthOrder::depth;
        const Skeleton tree = grow(params);
        const auto sums = shared_out(tree);
        for (std::size_t i = 0; i < tree.branches.size(); ++i) {
            const Branch& branch = tree.branches[i];
            const auto sum = sums.find(static_cast<std::int32_t>(i));
            if (branch.energy <= params.growth.stop_energy) {
                EXPECT_EQ(sum, sums.end());
            } else {
                ASSERT_NE(sum, sums.end());
                EXPECT_NEAR(sum->second, branch.energy, 1e-9);
            }
        }
    }
}

TEST_P(GrowBothTypes, PlainTreesDrawFromThePapersRanges) {
    for (const double vary : {1.0, 0.3}) {
        Draws all;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            EnergyParams params = params_of(GetParam(), 500, seed);
            // Within one family the members are alike: only over families is the law uniform.
            params.variant.family = seed;
            params.variant.vary = vary;
            const Draws draws = draws_of(grow(params), params);
            all.shares.insert(all.shares.end(), draws.shares.begin(), draws.shares.end());
            all.turns.insert(all.turns.end(), draws.turns.begin(), draws.turns.end());
        }
        ASSERT_GT(all.shares.size(), 5000U);
        EXPECT_GT(kolmogorov_p(all.shares, identity), 0.001) << "vary " << vary;
        EXPECT_GT(kolmogorov_p(all.turns, identity), 0.001) << "vary " << vary;
    }
}

// The same test must see that competition bends the law of the turns.
TEST_P(GrowBothTypes, CompetitionIsNotUniform) {
    Draws all;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        EnergyParams params = params_of(GetParam(), 500, seed);
        params.space.candidates = 8;
        params.space.habit_rad = {0};
        params.space.habit_weight = 100;
        const Draws draws = draws_of(grow(params), params);
        all.turns.insert(all.turns.end(), draws.turns.begin(), draws.turns.end());
    }
    EXPECT_LT(kolmogorov_p(all.turns, identity), 1e-6);
}

TEST_P(GrowBothTypes, LengthAndWidthFollowEnergy) {
    const EnergyParams params = params_of(GetParam(), 200);
    const Skeleton tree = grow(params);
    for (const Branch& branch : tree.branches) {
        const Vec2 along = branch.end - tree.start(branch);
        EXPECT_NEAR(std::hypot(along.x, along.y),
                    params.growth.length_mm * std::pow(branch.energy, params.growth.length_power),
                    1e-9);
    }
    EXPECT_NEAR(branch_width_mm(params.growth, 100), 10 * branch_width_mm(params.growth, 1), 1e-12);
}

TEST_P(GrowBothTypes, TheOrderOfGrowthChangesNoPlainTree) {
    EnergyParams params = params_of(GetParam(), 300);
    std::map<Key, Vec2> ends;
    for (const Branch& branch : grow(params).branches)
        ends[branch.key] = branch.end;
    params.growth.order = GrowthOrder::energy;
    const Skeleton other = grow(params);
    ASSERT_EQ(other.branches.size(), ends.size());
    for (const Branch& branch : other.branches)
        EXPECT_EQ(ends.at(branch.key), branch.end);
}

TEST_P(GrowBothTypes, NoBranchEndsWhereItsCellWasFull) {
    EnergyParams params = params_of(GetParam(), 500);
    params.space.candidates = 4;
    params.space.drop = 0.5;
    const Skeleton tree = grow(params);
    EXPECT_FALSE(tree.dropped.empty());
    // Grown again on a map of the cells: each end's cell was below the threshold on arrival.
    std::map<std::pair<long, long>, double> cells;
    for (std::size_t i = 0; i < tree.branches.size(); ++i) {
        const Branch& branch = tree.branches[i];
        const double cell = params.space.cell_mm;
        const std::pair at{std::lround(std::floor(branch.end.x / cell)),
                           std::lround(std::floor(branch.end.y / cell))};
        if (i > 0) {
            EXPECT_LT(cells[at], params.space.drop);
        }
        cells[at] += static_cast<float>(branch_width_mm(params.growth, branch.energy) / cell);
    }
}

TEST_P(GrowBothTypes, TerminalsAreWhereGrowthEnded) {
    EnergyParams params = params_of(GetParam(), 400);
    params.space.drop = 0.4;
    for (const bool drop_leaf : {true, false}) {
        params.space.drop_leaf = drop_leaf;
        const Skeleton tree = grow(params);
        std::vector<int> children(tree.branches.size(), 0);
        for (const Branch& branch : tree.branches) {
            if (branch.parent >= 0) ++children[static_cast<std::size_t>(branch.parent)];
        }
        for (std::size_t i = 0; i < children.size(); ++i) {
            const Branch& branch = tree.branches[i];
            const bool spent = branch.energy <= params.growth.stop_energy;
            EXPECT_EQ(branch.terminal, spent || (drop_leaf && children[i] == 0));
        }
    }
}

TEST_P(GrowBothTypes, VaryZeroMakesAllMembersEqualAndDistanceRisesWithIt) {
    const auto member = [&](std::uint64_t seed, double vary) {
        EnergyParams params = params_of(GetParam(), 200, seed);
        params.variant.vary = vary;
        std::map<Key, Vec2> ends;
        for (const Branch& branch : grow(params).branches)
            ends[branch.key] = branch.end;
        return ends;
    };
    // Mean distance between branches of the same key, over pairs of members.
    const auto distance = [&](double vary) {
        double sum = 0;
        int count = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const auto a = member(seed, vary), b = member(seed + 100, vary);
            for (const auto& [key, end] : a) {
                const auto other = b.find(key);
                if (other == b.end()) continue;
                sum += std::hypot(end.x - other->second.x, end.y - other->second.y);
                ++count;
            }
        }
        return sum / count;
    };
    EXPECT_EQ(member(1, 0), member(2, 0));
    double last = 0;
    for (const double vary : {0.1, 0.3, 0.6, 1.0}) {
        const double now = distance(vary);
        EXPECT_GT(now, last) << "vary " << vary;
        last = now;
    }
}

TEST(Grow, HabitTurnsTheTwigsItsWay) {
    const auto mean_heading = [](double habit_rad) {
        EnergyParams params = params_of(TreeType::a, 300);
        params.space.candidates = 8;
        params.space.habit_rad = {habit_rad};
        params.space.habit_weight = 20;
        double sum = 0;
        const Skeleton tree = grow(params);
        for (const Branch& branch : tree.branches)
            sum += std::abs(std::remainder(branch.heading_rad, 2 * std::numbers::pi));
        return sum / static_cast<double>(tree.branches.size());
    };
    EXPECT_LT(mean_heading(0), radians(25));
    EXPECT_NEAR(mean_heading(radians(90)), radians(90), radians(20));
    EXPECT_GT(mean_heading(radians(180)), radians(140));
}

TEST(Grow, NothingEndsBelowTheClearance) {
    EnergyParams params = params_of(TreeType::a, 300);
    params.space.candidates = 4;
    params.space.habit_rad = {radians(170)};
    params.space.habit_weight = 20;
    const auto lowest = [&] {
        double low = 1e9;
        for (const Branch& branch : grow(params).branches)
            low = std::min(low, branch.end.y);
        return low;
    };
    EXPECT_LT(lowest(), 0);
    params.space.clearance_mm = 5;
    EXPECT_GE(lowest(), 5);
}

TEST(Grow, WeepingTurnsTwigsDownAndLeavesTheTrunk) {
    const auto headings = [](double weep) {
        EnergyParams params = params_of(TreeType::a, 300);
        params.space.candidates = 8;
        params.space.habit_weight = 20;
        params.space.weep = weep;
        double twigs = 0, heavy = 0;
        int twig_count = 0, heavy_count = 0;
        for (const Branch& branch : grow(params).branches) {
            const double away = std::abs(std::remainder(branch.heading_rad, 2 * std::numbers::pi));
            if (branch.terminal) twigs += away, ++twig_count;
            if (branch.energy > 150) heavy += away, ++heavy_count;
        }
        return std::pair(twigs / twig_count, heavy / heavy_count);
    };
    EXPECT_GT(headings(1).first, headings(0).first + radians(60));
    EXPECT_LT(headings(1).second, radians(45));
}

TEST(Grow, OppositeChildrenTurnToEitherSideAndLateralsAlternate) {
    EnergyParams params = params_of(TreeType::a, 300);
    params.branch.opposite = true;
    params.branch.turn_rad = {radians(10), radians(40)};
    const Skeleton tree = grow(params);
    std::map<std::int32_t, std::vector<double>> turns;
    for (const Branch& branch : tree.branches) {
        if (branch.parent < 0) continue;
        turns[branch.parent].push_back(
            branch.heading_rad -
            tree.branches[static_cast<std::size_t>(branch.parent)].heading_rad);
    }
    for (const auto& [parent, both] : turns) {
        ASSERT_EQ(both.size(), 2U);
        EXPECT_LT(both[0] * both[1], 0);
    }
}

TEST(Grow, ALimitIsAnErrorNotACrash) {
    EnergyParams params = params_of(TreeType::a, 1e6);
    params.growth.max_branches = 1000;
    try {
        grow(params);
        FAIL();
    } catch (const IoError& error) {
        EXPECT_STREQ(error.what(),
                     "growth.max-branches: the tree has more than 1000 branches; lower "
                     "growth.energy or raise the limit");
    }
}

TEST(Grow, AVeryDeepTreeCostsNoStack) {
    EnergyParams params = params_of(TreeType::a, 3000);
    params.growth.share = {0.9995, 0.9995};
    params.growth.stop_energy = 1;
    EXPECT_GT(grow(params).branches.size(), 16'000U);
}

}  // namespace edaha
