// SPDX-License-Identifier: MIT
#include "app/batch/plan.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "app/batch/plan_command.h"
#include "style/style_xml.h"
#include "support/run.h"

namespace edaha {
namespace {

class Plan : public testing::Test {
  protected:
    Plan() {
        options_.batch.sources = {"cherry"};
        options_.batch.count = "5";
    }

    BatchPlan plan() { return BatchPlan(options_, catalogue_, leaves_, console_); }

    std::string error() {
        try {
            plan();
        } catch (const UsageError& wrong) {
            return wrong.what();
        }
        return "";
    }

    std::vector<std::string> differing(const BatchPlan& made) {
        std::vector<std::string> keys;
        for (const Parameter* parameter : made.differing())
            keys.push_back(parameter->key());
        return keys;
    }

    std::istringstream in_;
    std::ostringstream out_;
    Console console_{in_, out_, out_, {}};
    Catalogue catalogue_;
    LeafShelf leaves_{catalogue_};
    Options options_;
};

TEST_F(Plan, EachVariantIsWhatItsCommandSays) {
    options_.tree.settings = {{"--vary", "variant.vary", "0..1"}};
    options_.tree.assignments = {"growth.energy=20..60", "palette.leaf=#102030..#908070"};
    options_.batch.sweeps = {"growth.type=A|B", "leaf.size=3..6"};
    options_.tree.palette = "main|dark";
    options_.tree.size = "12cm";
    const BatchPlan made = plan();
    ASSERT_EQ(made.variants(), 5u);
    for (std::size_t i = 0; i < made.variants(); ++i) {
        const Variant variant = made.variant(i);
        // The words of the command, as draw would get them. None needs quotes but colours.
        std::istringstream words(variant.tree.command);
        TreeOptions again;
        std::string word, value;
        words >> word >> word >> again.style;
        while (words >> word >> value) {
            if (value.starts_with('\'')) value = value.substr(1, value.size() - 2);
            if (word == "--set") again.assignments.push_back(value);
            if (word == "--seed") again.settings.push_back({word, "variant.seed", value});
            if (word == "--vary") again.settings.push_back({word, "variant.vary", value});
            if (word == "--palette") again.palette = value;
            if (word == "--size") again.size = value;
        }
        const TreeStyle drawn = read_tree_style(again, catalogue_, console_);
        EXPECT_EQ(to_xml(drawn.style), to_xml(variant.tree.style));
        EXPECT_EQ(drawn.command, variant.tree.command);
    }
}

TEST_F(Plan, GoesStyleByStyle) {
    options_.batch.sources = {"cherry", "oak"};
    options_.batch.seed_from = "40";
    const BatchPlan made = plan();
    EXPECT_EQ(made.variants(), 10u);
    EXPECT_EQ(made.name(0), "cherry-0040");
    EXPECT_EQ(made.name(4), "cherry-0044");
    EXPECT_EQ(made.name(5), "oak-0040");
    EXPECT_EQ(made.variant(9).tree.style.energy.variant.seed, 44);
}

TEST_F(Plan, NamesMayHoldAnyField) {
    options_.batch.name = "{palette}/{index:03}-{family}-{growth.energy}-{growth.type}";
    options_.batch.sweeps = {"growth.energy=10..50"};
    const BatchPlan made = plan();
    EXPECT_EQ(made.name(0), "main/001-1-10-B");
    EXPECT_EQ(made.name(4), "main/005-1-50-B");
}

TEST_F(Plan, WhatDiffersIsSetOrOfTheStyles) {
    EXPECT_EQ(differing(plan()), std::vector<std::string>{});
    options_.tree.assignments = {"leaf.size=4", "growth.energy=20..60"};
    options_.tree.size = "120mm";
    EXPECT_EQ(differing(plan()),
              (std::vector<std::string>{"growth.energy", "leaf.size", "page.size"}));
    options_.batch.sources = {"cherry", "oak"};
    const std::vector<std::string> both = differing(plan());
    EXPECT_EQ(std::ranges::count(both, "leaf.shape"), 1);
    EXPECT_EQ(std::ranges::count(both, "variant.seed"), 0);
}

TEST_F(Plan, TheRecipeTellsRunsApart) {
    const std::string recipe = plan().recipe();
    EXPECT_EQ(plan().recipe(), recipe);
    options_.batch.jobs = "7";
    options_.batch.shard = "1/2";
    options_.output = "elsewhere";
    EXPECT_EQ(plan().recipe(), recipe);
    options_.tree.assignments = {"leaf.size=4"};
    EXPECT_NE(plan().recipe(), recipe);
}

TEST_F(Plan, EqualNamesAreRefused) {
    options_.batch.name = "{style}";
    EXPECT_EQ(error(), "--name: cherry with seed 1 and cherry with seed 2 would both be 'cherry'");
    options_.batch.name.clear();
    options_.batch.sources = {"oak", "cherry", "oak"};
    EXPECT_EQ(error(), "--name: oak with seed 1 and oak with seed 1 would both be 'oak-0001'");
}

TEST_F(Plan, WrongValuesAreFoundBeforehand) {
    options_.batch.count = "0";
    EXPECT_EQ(error(), "-n: '0' is out of range (expected 1 … 1000000)");
    options_.batch.count = "1000001";
    EXPECT_EQ(error(), "-n: '1000001' is out of range (expected 1 … 1000000)");
    options_.batch.count = "5";
    options_.batch.seed_from = "9007199254740988";
    EXPECT_EQ(error(),
              "--seed-from: '9007199254740988' is out of range (expected 0 … 9007199254740987)");
    options_.batch.seed_from.clear();
    options_.tree.palette = "dark|drak";
    EXPECT_EQ(error(), "'cherry' has no palette 'drak' (did you mean 'dark'?)");
    options_.tree.palette.clear();
    options_.format = "svg,pdf,svg";
    EXPECT_EQ(error(), "--format: svg is given twice");
    options_.format = "svg,";
    EXPECT_EQ(error(), "--format: '' is not known (expected svg, svgz, pdf, png or eps)");
    options_.format.clear();
    options_.tree.assignments = {"leaf.shape=oak-leaf|no-such-leaf"};
    EXPECT_THROW(plan(), InputError);
}

TEST(PlanCommand, LeavesOutWhatDecidesNoBytes) {
    Options options;
    options.batch.sources = {"cherry", "my oak.xml"};
    options.batch.count = "5";
    options.output = "out";
    options.force = true;
    options.batch.resume = true;
    options.batch.jobs = "2";
    options.batch.shard = "1/2";
    options.tree.assignments = {"growth.type=A|B"};
    options.format = "svg,pdf";
    EXPECT_EQ(plan_command(options),
              "edaha batch cherry 'my oak.xml' -n 5 --set 'growth.type=A|B' --format svg,pdf");
}

}  // namespace
}  // namespace edaha
