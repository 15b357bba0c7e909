// SPDX-License-Identifier: MIT
#include "style/samples.h"

#include <set>

#include <gtest/gtest.h>

#include "style/style.h"
#include "style/value.h"

namespace edaha {
namespace {

std::vector<std::string> samples_of(const char* key) {
    return samples(*find_parameter(key));
}

TEST(Samples, AreValuesOfTheirParameterEachOnce) {
    for (const Parameter& parameter : parameters()) {
        const std::vector<std::string> values = samples(parameter);
        std::set<std::string> canonical;
        for (const std::string& value : values) {
            Style style;
            EXPECT_EQ(assign(style, parameter, value), std::nullopt) << parameter.key() << value;
            canonical.insert(value_text(style, parameter));
        }
        EXPECT_EQ(canonical.size(), values.size()) << parameter.key();
    }
}

TEST(Samples, ThereAreSomeOfAllThatCanBeSeen) {
    for (const Parameter& parameter : parameters()) {
        const bool colour = std::holds_alternative<Tint>(parameter.field);
        const bool unseen = parameter.key() == "growth.max-branches" ||
                            parameter.key() == "prism.limit" ||
                            parameter.key() == "surface.face-limit";
        EXPECT_EQ(samples(parameter).empty(), colour || unseen) << parameter.key();
    }
}

TEST(Samples, UsualRangesLieWithinTheLimits) {
    for (const Parameter& parameter : parameters()) {
        const Range usual = usual_range(parameter);
        if (usual.low == usual.high) continue;
        EXPECT_GE(usual.low, parameter.limits.least) << parameter.key();
        EXPECT_LE(usual.high, parameter.limits.most) << parameter.key();
    }
}

TEST(Samples, StepEvenlyOrByEvenFactors) {
    EXPECT_EQ(samples_of("leaf.droop"),
              (std::vector<std::string>{"0", "0.25", "0.5", "0.75", "1"}));
    EXPECT_EQ(samples_of("growth.energy"),
              (std::vector<std::string>{"20", "40", "80", "160", "320"}));
    EXPECT_EQ(samples_of("space.candidates"), (std::vector<std::string>{"1", "2", "4", "8", "16"}));
}

TEST(Samples, RangesFollowEachOtherOrWiden) {
    EXPECT_EQ(samples_of("branch.right-turn"),
              (std::vector<std::string>{"0..20", "20..40", "40..60", "60..80", "80..100"}));
    EXPECT_EQ(samples_of("growth.lean"),
              (std::vector<std::string>{"-8..8", "-16..16", "-24..24", "-32..32", "-40..40"}));
}

TEST(Samples, OfChoicesAreItsNames) {
    EXPECT_EQ(samples_of("look.ground"),
              (std::vector<std::string>{"none", "shadow", "mound", "water"}));
    EXPECT_EQ(samples_of("branch.opposite"), (std::vector<std::string>{"no", "yes"}));
}

}  // namespace
}  // namespace edaha
