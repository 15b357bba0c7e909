// SPDX-License-Identifier: MIT
#include "base/keyed_random.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/kolmogorov.h"

namespace edaha {

TEST(KeyedRandom, IsUniformAtAnyVary) {
    for (const double vary : {0.0, 0.3, 0.7, 1.0}) {
        const KeyedRandom random(5, 9, vary);
        std::vector<double> values;
        for (Key key = 0; key < 20'000; ++key)
            values.push_back(random.uniform(key, 1));
        EXPECT_GT(kolmogorov_p(values, [](double u) { return u; }), 0.001) << "vary " << vary;
    }
}

// Across members at one key, not along the keys: this is what "uniform for each tree" means.
TEST(KeyedRandom, IsUniformOverMembersAtOnePlace) {
    std::vector<double> values;
    for (std::uint64_t family = 0; family < 20'000; ++family) {
        values.push_back(KeyedRandom(family, family, 0.3).uniform(77, 2));
    }
    EXPECT_GT(kolmogorov_p(values, [](double u) { return u; }), 0.001);
}

TEST(KeyedRandom, VaryZeroFollowsTheFamilyAndOneTheMember) {
    EXPECT_EQ(KeyedRandom(1, 2, 0).uniform(7, 1), KeyedRandom(1, 3, 0).uniform(7, 1));
    EXPECT_NE(KeyedRandom(1, 2, 0).uniform(7, 1), KeyedRandom(2, 2, 0).uniform(7, 1));
    EXPECT_EQ(KeyedRandom(1, 2, 1).uniform(7, 1), KeyedRandom(4, 2, 1).uniform(7, 1));
    EXPECT_NE(KeyedRandom(1, 2, 1).uniform(7, 1), KeyedRandom(1, 3, 1).uniform(7, 1));
}

// Correlation of two members of a family in normal scores is 1 - vary^2.
TEST(KeyedRandom, LikenessOfMembersIsWhatVarySays) {
    const double vary = 0.6;
    const KeyedRandom a(1, 2, vary), b(1, 3, vary);
    double sum = 0;
    const int count = 40'000;
    for (int key = 0; key < count; ++key) {
        const double u = a.uniform(static_cast<Key>(key), 1),
                     v = b.uniform(static_cast<Key>(key), 1);
        sum += (u - 0.5) * (v - 0.5) * 12;
    }
    // For a Gaussian copula, Spearman's rho = 6/pi asin(r/2).
    const double expected = 6 / std::acos(-1.0) * std::asin((1 - vary * vary) / 2);
    EXPECT_NEAR(sum / count, expected, 4 / std::sqrt(count));
}

TEST(KeyedRandom, PurposesAndIndicesAreIndependent) {
    const KeyedRandom random(1, 1, 1);
    double sum = 0;
    const int count = 40'000;
    for (int key = 0; key < count; ++key) {
        const auto k = static_cast<Key>(key);
        sum += (random.uniform(k, 1, 0) - 0.5) * (random.uniform(k, 1, 1) - 0.5) * 12;
        sum += (random.uniform(k, 1, 0) - 0.5) * (random.uniform(k, 2, 0) - 0.5) * 12;
    }
    EXPECT_NEAR(sum / count, 0, 6 / std::sqrt(count));
}

}  // namespace edaha
