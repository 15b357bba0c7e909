// SPDX-License-Identifier: MIT
#include "app/tree_style.h"

#include <sstream>

#include <gtest/gtest.h>

#include "base/error.h"

namespace edaha {
namespace {

TreeStyle read(const TreeOptions& options, const std::string& input = "") {
    std::istringstream in(input);
    std::ostringstream out, err;
    Console console{in, out, err, {}};
    return read_tree_style(options, Catalogue(), console);
}

template <class Call>
std::string usage_error(const Call& call) {
    try {
        call();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Length, AllUnitsAreMillimetres) {
    EXPECT_EQ(parse_length_mm("--size", "120mm"), 120);
    EXPECT_EQ(parse_length_mm("--size", "12 cm"), 120);
    EXPECT_EQ(parse_length_mm("--size", "2in"), 50.8);
    EXPECT_DOUBLE_EQ(parse_length_mm("--size", "96px"), 25.4);
    EXPECT_DOUBLE_EQ(parse_length_mm("--size", "72pt"), 25.4);
}

TEST(Length, OthersAreRefused) {
    for (const std::string wrong : {"120", "mm", "1m", "1,5cm", ""}) {
        EXPECT_EQ(
            usage_error([&] { parse_length_mm("--size", wrong); }),
            "--size: '" + wrong + "' is not a length (expected a number and mm, cm, in, px or pt)");
    }
    for (const std::string wrong : {"0mm", "-1cm", "1001cm"}) {
        EXPECT_EQ(usage_error([&] { parse_length_mm("--size", wrong); }),
                  "--size: '" + wrong + "' is out of range (expected above 0, up to 10000mm)");
    }
}

TEST(TreeStyle, OptionsChangeTheStyle) {
    TreeOptions options;
    options.style = "-";
    options.settings = {{"--seed", "variant.seed", "7"}};
    options.assignments = {"growth.energy=50"};
    options.palette = "dark";
    options.size = "10cm";
    options.background = true;
    const TreeStyle tree =
        read(options, "<tree name='x'><palette name='dark' paper='#000000'/></tree>");
    EXPECT_EQ(tree.style.energy.variant.seed, 7U);
    EXPECT_EQ(tree.style.energy.growth.energy, 50);
    EXPECT_EQ(tree.style.palette.paper, (Colour{0, 0, 0}));
    EXPECT_EQ(tree.style.page.size_mm, 100);
    EXPECT_TRUE(tree.style.page.background);
    EXPECT_EQ(tree.command,
              "edaha draw - --seed 7 --set growth.energy=50 --palette dark --size 10cm "
              "--background");
}

TEST(TreeStyle, SingleValuesComeAfterThePalette) {
    TreeOptions options;
    options.style = "-";
    options.assignments = {"palette.paper=#ffffff"};
    options.palette = "dark";
    const TreeStyle tree =
        read(options, "<tree name='x'><palette name='dark' paper='#000000'/></tree>");
    EXPECT_EQ(tree.style.palette.paper, (Colour{255, 255, 255}));
}

TEST(TreeStyle, CommandsAreQuotedForAShell) {
    TreeOptions options;
    options.style = "-";
    options.assignments = {"leaf.shape=it's a leaf.svg"};
    EXPECT_EQ(read(options, "<tree name='x'/>").command,
              "edaha draw - --set 'leaf.shape=it'\\''s a leaf.svg'");
}

TEST(TreeStyle, WrongValuesAreWrongUse) {
    TreeOptions options;
    options.style = "-";
    const auto error = [&] { return usage_error([&] { read(options, "<tree name='x'/>"); }); };
    options.settings = {{"--vary", "variant.vary", "2"}};
    EXPECT_EQ(error(), "--vary: '2' is out of range (expected 0 … 1)");
    options.settings.clear();
    options.palette = "dark";
    EXPECT_EQ(error(), "'x' has no palette 'dark' (it has none but its own)");
    options.palette.clear();
    options.assignments = {"a=1", "b=2"};
    EXPECT_EQ(error(), "--set: a: no such parameter\nedaha: --set: b: no such parameter");
}

TEST(TreeStyle, AWrongStyleIsAnInputError) {
    TreeOptions options;
    options.style = "-";
    EXPECT_THROW(read(options, "<tree/>"), InputError);
}

}  // namespace
}  // namespace edaha
