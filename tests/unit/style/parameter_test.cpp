// SPDX-License-Identifier: MIT
#include "style/parameter.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "style/catalogue.h"
#include "style/value.h"

namespace edaha {
namespace {

TEST(Parameter, KeysAreUniqueNames) {
    std::set<std::string> keys;
    for (const Parameter& parameter : parameters()) {
        EXPECT_TRUE(keys.insert(parameter.key()).second) << parameter.key();
        EXPECT_TRUE(is_name(parameter.group)) << parameter.group;
        std::string name = parameter.name;
        if (parameter.group == "proproot") std::ranges::replace(name, '_', '-');  // a thesis' names
        EXPECT_TRUE(is_name(name)) << parameter.key();
        EXPECT_NE(parameter.key(), "palette.name");  // the attribute that names a palette
    }
}

TEST(Parameter, GroupsHoldTheWholeTable) {
    std::size_t rows = 0;
    for (const ParameterGroup& group : parameter_groups()) {
        EXPECT_FALSE(group.parameters.empty()) << group.name;
        for (const Parameter& parameter : group.parameters)
            EXPECT_EQ(parameter.group, group.name);
        rows += group.parameters.size();
        EXPECT_EQ(find_group(group.name), &group);
    }
    EXPECT_EQ(rows, parameters().size());
    EXPECT_EQ(find_group("growths"), nullptr);
}

TEST(Parameter, DefaultsAreGoodValues) {
    for (const Parameter& parameter : parameters()) {
        Style style;
        const std::string text = value_text(style, parameter);
        EXPECT_EQ(assign(style, parameter, text), std::nullopt) << parameter.key();
        EXPECT_EQ(value_text(style, parameter), text) << parameter.key();
    }
}

// A text that differs from the default, whatever the kind.
std::string other_text(const Parameter& parameter) {
    const Limits& limits = parameter.limits;
    const std::string now = value_text(Style(), parameter);
    std::vector<std::string> texts = {
        shortest_text(limits.least), shortest_text(limits.most), "yes", "no", "#010203", "x"};
    if (const auto* choice = std::get_if<Choice>(&parameter.field)) texts = choice->names;
    for (const std::string& text : texts) {
        Style style;
        if (!assign(style, parameter, text) && value_text(style, parameter) != now) return text;
    }
    return {};
}

TEST(Parameter, EachReachesItsOwnValueAndNoOther) {
    for (const Parameter& parameter : parameters()) {
        Style style;
        const std::string text = other_text(parameter);
        ASSERT_EQ(assign(style, parameter, text), std::nullopt) << parameter.key();
        for (const Parameter& other : parameters()) {
            const bool same = value_text(style, other) == value_text(Style(), other);
            EXPECT_EQ(same, &other != &parameter) << parameter.key() << " and " << other.key();
        }
    }
}

TEST(Parameter, ValuesBeyondTheLimitsAreRefused) {
    for (const Parameter& parameter : parameters()) {
        const bool whole = std::holds_alternative<Integer>(parameter.field);
        if (!whole && !std::holds_alternative<Number>(parameter.field)) continue;
        const double beyond = whole ? 1 : 1e-3;
        for (const double value :
             {parameter.limits.least - beyond, parameter.limits.most + beyond}) {
            Style style;
            EXPECT_NE(assign(style, parameter, shortest_text(value)), std::nullopt)
                << parameter.key() << ' ' << value;
            EXPECT_EQ(value_text(style, parameter), value_text(Style(), parameter));
        }
    }
}

TEST(Parameter, HelpIsALineWithASource) {
    for (const Parameter& parameter : parameters()) {
        EXPECT_FALSE(parameter.help.empty()) << parameter.key();
        EXPECT_LE(parameter.help.size(), 90U) << parameter.key();
        EXPECT_FALSE(parameter.help.ends_with('.')) << parameter.key();
        EXPECT_TRUE(parameter.source.starts_with("paper ") || parameter.source == "Edaha")
            << parameter.key();
    }
}

TEST(Parameter, TheNearestKeyIsOffered) {
    EXPECT_EQ(unknown_parameter("growth.enery"),
              "growth.enery: no such parameter (did you mean 'growth.energy'?)");
    EXPECT_EQ(unknown_parameter("x"), "x: no such parameter");
}

// Stands for a value of any type in an initializer, to count the members of a struct.
struct Anything {
    template <class T>
    operator T() const;
};

template <class Params, class... Members>
constexpr std::size_t count_members(Members... members) {
    if constexpr (requires { Params{members..., Anything{}}; }) {
        return count_members<Params>(members..., Anything{});
    } else {
        return sizeof...(Members);
    }
}

template <class Params>
constexpr std::size_t kMembers = count_members<Params>();

TEST(Parameter, EveryMemberOfAStagesParamsHasItsRow) {
    const auto rows = [](const char* group) { return find_group(group)->parameters.size(); };
    EXPECT_EQ(rows("growth"), kMembers<GrowthParams>);
    EXPECT_EQ(rows("branch"), kMembers<BranchParams>);
    EXPECT_EQ(rows("space"), kMembers<SpaceParams>);
    EXPECT_EQ(rows("variant"), kMembers<VariantParams>);
    EXPECT_EQ(rows("prism") + 1, kMembers<PrismParams>);  // its foliage is a group of its own
    EXPECT_EQ(rows("foliage"), kMembers<FoliageParams>);
    EXPECT_EQ(rows("proproot"), kMembers<PropRootParams>);
    EXPECT_EQ(rows("look"), kMembers<LookParams>);
    EXPECT_EQ(rows("leaf"), kMembers<OrnamentParams>);
    EXPECT_EQ(rows("blossom"), kMembers<OrnamentParams>);
    EXPECT_EQ(rows("fruit"), kMembers<OrnamentParams>);
    EXPECT_EQ(rows("palette"), kMembers<Palette>);
    EXPECT_EQ(rows("page"), kMembers<PageParams>);
}

}  // namespace
}  // namespace edaha
