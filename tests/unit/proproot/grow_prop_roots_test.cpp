// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.h"
#include "proproot/prop_roots.h"
#include "proproot/root_tables.h"

namespace edaha::test {
namespace {

constexpr double kPi = std::numbers::pi;

PropRoots grown(const PropRootParams& params, std::uint64_t seed, double vary = 1) {
    return grow_prop_roots(params, KeyedRandom(1, seed, vary));
}

PropRootParams with_primaries(int x) {
    PropRootParams params;
    params.primaries = x;
    return params;
}

const PropRoot* parent_of(const PropRoots& plant, const PropRoot& root) {
    return root.parent < 0 ? nullptr : &plant.roots[static_cast<std::size_t>(root.parent)];
}

// Calls check(plant, root, params) for the roots of plants of every age and type.
template <typename Check>
void for_many_roots(const Check& check) {
    for (const int x : {1, 5, 8, 14, 18, 30, 60}) {
        for (const RootType type : {RootType::standard, RootType::gentle, RootType::steep}) {
            PropRootParams params = with_primaries(x);
            params.type = type;
            const PropRoots plant = grown(params, 7);
            for (const PropRoot& root : plant.roots)
                check(plant, root, params);
        }
    }
}

TEST(GrowPropRoots, SagsAreThoseOfTheTypeAndTurn) {
    for_many_roots([](const PropRoots&, const PropRoot& root, const PropRootParams& params) {
        const Range range = params.type == RootType::gentle  ? Range{300, 550}
                            : params.type == RootType::steep ? Range{10, 70}
                                                             : Range{150, 330};
        const double a = root.curve.a * slope_factor(root.turn_rad);
        EXPECT_LE(-a, range.high + 1e-9);
        EXPECT_GE(-a, range.low - 1e-9);
    });
}

TEST(GrowPropRoots, BranchingPointsKeepTheirHeights) {
    for_many_roots([](const PropRoots& plant, const PropRoot& root, const PropRootParams&) {
        EXPECT_GE(root.base.y, 9 - 1e-9);
        EXPECT_NEAR(root.base.y, root.curve.height(0), 1e-9);
        if (const PropRoot* parent = parent_of(plant, root)) {
            EXPECT_GE(root.base.y, 0.15 * parent->base.y - 1e-9);
            EXPECT_LE(root.base.y, 0.80 * parent->base.y + 1e-9);
            EXPECT_LT(glm::distance(root.base, parent->at(root.parent_along)), 1e-9);
        } else {
            EXPECT_LE(root.base.y, root_age(plant.primaries).highest);
            const Vec3 middle = plant.trunk.centre(root.base.y);
            EXPECT_NEAR(glm::distance(root.base, middle), plant.trunk.radius(root.base.y), 1e-9);
        }
    });
}

TEST(GrowPropRoots, OrdersAndForksKeepToTheTables) {
    for (const int x : {1, 5, 6, 8, 9, 14, 15, 18, 19, 30, 31, 50, 51, 100}) {
        const PropRoots plant = grown(with_primaries(x), 3);
        const RootAge& age = root_age(x);
        std::map<std::int32_t, int> children;
        for (const PropRoot& root : plant.roots) {
            EXPECT_LE(root.order, static_cast<unsigned>(age.max_order));
            const PropRoot* parent = parent_of(plant, root);
            EXPECT_EQ(root.order, parent == nullptr ? 1U : parent->order + 1);
            EXPECT_NEAR(root.radius, (1 + x / 10.0) * std::pow(0.8, root.order - 1.0), 1e-12);
            if (parent != nullptr) {
                EXPECT_LE(++children[root.parent], age.max_branchings);
                EXPECT_LT(parent, &root);
            }
        }
    }
}

TEST(GrowPropRoots, TheUsersLimitsReplaceTheTables) {
    PropRootParams params = with_primaries(8);
    params.max_order = 3;
    params.branchings = 3;
    params.max_branchings = 1;
    params.highest = 100;
    std::set<unsigned> orders;
    bool above_table = false;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const PropRoots plant = grown(params, seed);
        std::map<std::int32_t, int> children;
        for (const PropRoot& root : plant.roots) {
            orders.insert(root.order);
            above_table |= root.base.y > 60;
            if (root.parent >= 0) {
                EXPECT_EQ(++children[root.parent], 1);
            }
        }
    }
    EXPECT_EQ(orders, (std::set<unsigned>{1, 2, 3}));
    EXPECT_TRUE(above_table);
}

TEST(GrowPropRoots, PrimariesStandEvenlyRoundTheTrunk) {
    for (const int x : {1, 6, 49}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            for (const PropRoot& root : grown(with_primaries(x), seed).roots) {
                if (root.order > 1) continue;
                const double even = 2 * kPi * (root.number - 1) / x;
                EXPECT_LE(std::abs(root.azimuth_rad - even), kPi / 3 / x + 1e-12);
            }
        }
    }
}

TEST(GrowPropRoots, DirectionsFollowTheWeights) {
    // Without redrawing, or what is in the way would have its say.
    PropRootParams params = with_primaries(49);
    params.apart = false;
    std::array<double, 9> share{};
    double total = 0, left = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        for (const PropRoot& root : grown(params, seed).roots) {
            if (root.order == 1) continue;
            const double degrees = std::abs(root.turn_rad) * 180 / kPi;
            EXPECT_LE(degrees, 170 + 1e-9);
            share[static_cast<std::size_t>(degrees / 20)] += 1;
            left += root.turn_rad < 0;
            total += 1;
        }
    }
    for (std::size_t bin = 0; bin < 9; ++bin) {
        const double expected = params.turn_weights[bin] / 100;
        // Four standard deviations of a count.
        const double allowed = 4 * std::sqrt(expected * (1 - expected) / total);
        EXPECT_NEAR(share[bin] / total, expected, allowed) << bin;
    }
    EXPECT_NEAR(left / total, 0.5, 2 / std::sqrt(total));
}

TEST(GrowPropRoots, BulgesRiseByAFifthAtMostAndAsOftenAsTheTypeHasIt) {
    const std::pair<RootType, double> shares[] = {
        {RootType::standard, 0.05}, {RootType::gentle, 0.10}, {RootType::steep, 0.01}};
    for (const auto& [type, share] : shares) {
        PropRootParams params = with_primaries(49);
        params.type = type;
        params.apart = false;
        double bulging = 0, total = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const PropRoots plant = grown(params, seed);
            bulging += double(plant.bulging);
            total += double(plant.roots.size());
            for (const PropRoot& root : plant.roots) {
                const double top = root.curve.height(root.curve.apex);
                EXPECT_LE(top, 1.2 * root.base.y + 1e-9);
                EXPECT_EQ(root.bulges, top > root.base.y + 1e-9);
            }
        }
        EXPECT_NEAR(bulging / total, share, 4 * std::sqrt(share * (1 - share) / total));
    }
}

// Sato's reference plant has 389 roots on 49 primaries, about 2 % of them bulging.
TEST(GrowPropRoots, PlantsOf49PrimariesAreAsRichAsTheReference) {
    PropRootParams params = with_primaries(49);
    params.bulges = 0.02;
    const auto mean_count = [&](bool apart) {
        params.apart = apart;
        double sum = 0, bulging = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const PropRoots plant = grown(params, seed);
            sum += double(plant.roots.size());
            bulging += double(plant.bulging);
        }
        EXPECT_NEAR(bulging / sum, 0.02, 0.005);
        return sum / 30;
    };
    const double before = mean_count(false), after = mean_count(true);
    EXPECT_NEAR(before, 389, 0.15 * 389);
    EXPECT_NEAR(after, 389, 0.15 * 389);
    EXPECT_LT(after, before);
    RecordProperty("before", std::to_string(before));
    RecordProperty("after", std::to_string(after));
}

TEST(GrowPropRoots, CountsAddUp) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const PropRoots plant = grown(with_primaries(60), seed);
        std::vector<std::size_t> by_order(plant.by_order.size(), 0);
        std::size_t bulging = 0;
        std::set<std::string> names;
        for (const PropRoot& root : plant.roots) {
            by_order.at(root.order - 1) += 1;
            bulging += root.bulges;
            names.insert(plant.name_of(root));
        }
        EXPECT_EQ(by_order, plant.by_order);
        EXPECT_EQ(bulging, plant.bulging);
        EXPECT_EQ(names.size(), plant.roots.size());
        // 60 fat primaries never all find room: those left out are counted.
        EXPECT_GE(plant.removed + plant.by_order[0], 60U);
    }
}

TEST(GrowPropRoots, LongerAndHigherRootsForkMore) {
    double short_roots = 0, short_forks = 0, long_roots = 0, long_forks = 0;
    std::uint32_t low_order = 0, high_order = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const PropRoots plant = grown(with_primaries(30), seed);
        std::vector<int> forks(plant.roots.size(), 0);
        std::vector<std::uint32_t> highest(plant.roots.size(), 0);
        for (std::size_t i = plant.roots.size(); i-- > 0;) {
            const PropRoot& root = plant.roots[i];
            highest[i] = std::max(highest[i], root.order);
            if (root.parent < 0) continue;
            const auto parent = static_cast<std::size_t>(root.parent);
            forks[parent] += 1;
            highest[parent] = std::max(highest[parent], highest[i]);
        }
        for (std::size_t i = 0; i < plant.roots.size(); ++i) {
            const PropRoot& root = plant.roots[i];
            if (root.young || root.order > 3) continue;
            (root.length < 120 ? short_roots : long_roots) += 1;
            (root.length < 120 ? short_forks : long_forks) += forks[i];
            if (root.order > 1) continue;
            if (root.base.y < 20) low_order = std::max(low_order, highest[i]);
            if (root.base.y > 80) high_order = std::max(high_order, highest[i]);
        }
    }
    EXPECT_GT(long_forks / long_roots, 1.5 * short_forks / short_roots);
    EXPECT_LT(low_order, high_order);
}

TEST(GrowPropRoots, YoungRootsEndInTheAirAndBearNone) {
    PropRootParams params = with_primaries(40);
    params.young = 0.3;
    double young = 0, total = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const PropRoots plant = grown(params, seed);
        for (const PropRoot& root : plant.roots) {
            young += root.young;
            total += 1;
            const double end = root.at(root.length).y;
            if (root.young) {
                EXPECT_GT(end, 0.1);
            } else {
                EXPECT_NEAR(end, 0, 1e-9);
            }
            if (const PropRoot* parent = parent_of(plant, root)) {
                EXPECT_FALSE(parent->young);
            }
        }
    }
    EXPECT_NEAR(young / total, 0.3, 0.05);
}

TEST(GrowPropRoots, GeometricHeightsAreDenseBelow) {
    PropRootParams params = with_primaries(50);
    params.heights = RootHeights::geometric;
    params.apart = false;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        std::vector<double> heights;
        for (const PropRoot& root : grown(params, seed).roots)
            if (root.order == 1) heights.push_back(root.base.y);
        std::sort(heights.rbegin(), heights.rend());
        // One on each rung of the ladder from 120 down to 9.
        for (int i = 0; i < 50; ++i) {
            EXPECT_LE(heights[static_cast<std::size_t>(i)],
                      120 * std::pow(9.0 / 120, i / 50.0) + 1e-9);
            EXPECT_GE(heights[static_cast<std::size_t>(i)],
                      120 * std::pow(9.0 / 120, (i + 1) / 50.0) - 1e-9);
        }
    }
}

TEST(GrowPropRoots, TheTrunkIsAFifthHigherThanAllRoots) {
    for_many_roots([](const PropRoots& plant, const PropRoot& root, const PropRootParams&) {
        EXPECT_GE(plant.trunk.height, 1.2 * root.curve.height(root.curve.apex) - 1e-9);
    });
    const PropRoots plant = grown(with_primaries(1), 1);
    const Catenary& only = plant.roots.at(0).curve;
    EXPECT_DOUBLE_EQ(plant.trunk.height, 1.2 * only.height(only.apex));
}

TEST(GrowPropRoots, MembersOfAFamilyAreAsLikeAsIsAsked) {
    const PropRootParams params = with_primaries(30);
    const auto same = [](const PropRoots& a, const PropRoots& b) {
        return std::equal(a.roots.begin(), a.roots.end(), b.roots.begin(), b.roots.end(),
                          [](const PropRoot& r, const PropRoot& s) {
                              return r.base == s.base && r.curve.a == s.curve.a &&
                                     r.azimuth_rad == s.azimuth_rad && r.length == s.length;
                          });
    };
    EXPECT_TRUE(same(grown(params, 1), grown(params, 1)));
    EXPECT_FALSE(same(grown(params, 1), grown(params, 2)));
    EXPECT_TRUE(same(grown(params, 1, 0), grown(params, 2, 0)));
    EXPECT_FALSE(same(grown(params, 1, 0.2), grown(params, 2, 0.2)));
}

TEST(GrowPropRoots, TooManyAreRefused) {
    PropRootParams params = with_primaries(100);
    params.highest = 1000;
    params.branchings = 20;
    params.max_branchings = 20;
    params.apart = false;
    try {
        grown(params, 1);
        FAIL();
    } catch (const IoError& error) {
        EXPECT_STREQ(error.what(),
                     "proproot.branchings: the plant has more than 20000 roots; lower it or "
                     "proproot.max_order");
    }
}

TEST(GrowPropRoots, OddWeightsDoNoHarm) {
    PropRootParams params = with_primaries(49);
    for (const std::vector<double>& weights :
         {std::vector<double>{}, std::vector<double>(9, 0), std::vector<double>{0, 0, 1},
          std::vector<double>(12, 1)}) {
        params.turn_weights = weights;
        for (const PropRoot& root : grown(params, 1).roots) {
            EXPECT_TRUE(std::isfinite(root.length));
            EXPECT_LE(std::abs(root.turn_rad), kPi * 170 / 180 + 1e-9);
            if (weights.size() == 3 && root.order > 1) {
                EXPECT_GE(std::abs(root.turn_rad), kPi * 40 / 180 - 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace edaha::test
