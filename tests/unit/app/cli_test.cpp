// SPDX-License-Identifier: MIT
#include "app/cli.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "style/parameter.h"
#include "support/run.h"

namespace edaha {
namespace {

struct Output {
    int code;
    std::string out;
    std::string err;
};

Output run_edaha(const std::vector<std::string>& arguments, const std::string& input = "",
                 const std::string& user_folder = "") {
    std::istringstream in(input);
    std::ostringstream out, err;
    Console console{in, out, err, user_folder};
    const int code = run(arguments, console);
    return {code, out.str(), err.str()};
}

constexpr const char* kSapling =
    "<tree name='sapling'><growth energy='20'/><page margin='2'/></tree>";

TEST(Cli, DrawsFromStandardInputToStandardOutput) {
    const Output output = run_edaha({"draw", "-", "-o", "-"}, kSapling);
    EXPECT_EQ(output.code, 0);
    EXPECT_EQ(output.err, "");
    EXPECT_TRUE(output.out.starts_with("<?xml")) << output.out.substr(0, 80);
    EXPECT_NE(output.out.find("edaha draw -"), std::string::npos);
}

TEST(Cli, APictureRedrawsItself) {
    const test::TemporaryFolder folder;
    const std::string first = folder / "first.svg";
    const std::string second = folder / "second.svg";
    ASSERT_EQ(run_edaha({"draw", "-", "--seed", "5", "-o", first}, kSapling).code, 0);
    ASSERT_EQ(run_edaha({"draw", first, "-o", second}).code, 0);
    EXPECT_EQ(test::read_whole(first), test::read_whole(second));
    ASSERT_EQ(run_edaha({"draw", first, "--seed", "6", "-o", second}).code, 0);
    EXPECT_NE(test::read_whole(first), test::read_whole(second));
    EXPECT_NE(test::read_whole(second).find("edaha draw - --seed 5 --seed 6"), std::string::npos);
}

TEST(Cli, OtherPicturesCanNotBeRedrawn) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "other.svg";
    test::write_whole(file, "<svg xmlns='http://www.w3.org/2000/svg'/>");
    const Output output = run_edaha({"draw", file, "-o", "-"});
    EXPECT_EQ(output.code, 1);
    EXPECT_EQ(output.err, "edaha: '" + file + "' does not say which style it was drawn from\n");
}

TEST(Cli, ReportsAreJsonWithStableKeys) {
    const auto keys = [](const std::string& text) {
        const auto json = nlohmann::ordered_json::parse(text);
        std::string names;
        for (const auto& [key, value] : json.items())
            names += key + ' ';
        return names;
    };
    const test::TemporaryFolder folder;
    const Output drawn =
        run_edaha({"draw", "-", "--json", "-o", folder / "x.png", "--width", "40"}, kSapling);
    EXPECT_EQ(keys(drawn.out),
              "file format bytes seed command width_mm height_mm branches limbs leaves warnings ");
    const auto report = nlohmann::json::parse(drawn.out);
    EXPECT_EQ(report["format"], "png");
    EXPECT_EQ(report["bytes"], test::read_whole(folder / "x.png").size());
    const Output measured = run_edaha({"measure", "-", "--json"}, kSapling);
    EXPECT_EQ(keys(measured.out),
              "style seed width_mm height_mm branches dropped limbs limbs_by_order "
              "bifurcation_ratio mean_turn_deg leaves layers shapes nodes bytes overlap_ratio ");
}

TEST(Cli, TypeAHasTwoBranchesAForkAndSharesEnergy) {
    // Every branch of energy above e_stop forks in two: branches are odd in number, and no more
    // than 2 E / e_stop x depth; with shares of a half exactly 2 x 16 - 1.
    const Output output = run_edaha({"measure", "-", "--json"},
                                    "<tree name='x'><growth type='A' energy='16' share='0.5'/>"
                                    "</tree>");
    const auto report = nlohmann::json::parse(output.out);
    EXPECT_EQ(report["branches"], 31);
    EXPECT_EQ(report["limbs"], 16);
    // Four forks deep, one way of two follows the limb: binomial coefficients.
    EXPECT_EQ(report["limbs_by_order"], (std::vector<int>{1, 4, 6, 4, 1}));
    EXPECT_NEAR(report["bifurcation_ratio"], std::sqrt(6.0), 1e-3);
    EXPECT_EQ(report["leaves"], 0);
}

TEST(Cli, TheSameCommandGivesTheSameBytes) {
    for (const char* format : {"svg", "svgz", "pdf", "png", "eps"}) {
        const std::vector<std::string> arguments = {"draw",     "-",    "-o",      "-",
                                                    "--format", format, "--width", "60"};
        const Output first = run_edaha(arguments, kSapling);
        EXPECT_EQ(first.code, 0) << first.err;
        EXPECT_GT(first.out.size(), 100U);
        EXPECT_EQ(first.out, run_edaha(arguments, kSapling).out) << format;
    }
}

TEST(Cli, NothingIsWrittenWhenAnythingIsWrong) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "x.svg";
    EXPECT_EQ(run_edaha({"draw", "-", "-o", file}, "<tree/>").code, 1);
    EXPECT_EQ(run_edaha({"draw", "-", "-o", file, "--size", "5"}, kSapling).code, 2);
    EXPECT_EQ(run_edaha({"draw", "-", "-o", file, "--dpi", "x"}, kSapling).code, 2);
    EXPECT_EQ(run_edaha({"draw", "-", "-o", file, "--set", "leaf.shape=gone"}, kSapling).code, 1);
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Cli, TheUsersStylesAreListed) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "styles");
    test::write_whole(folder / "styles/aaa.xml", kSapling);
    test::write_whole(folder / "styles/aab.xml", "<tree/>");
    const Output names = run_edaha({"styles", "--names"}, "", folder.path());
    EXPECT_TRUE(names.out.starts_with("aaa\naab\n")) << names.out;
    const Output list = run_edaha({"styles"}, "", folder.path());
    EXPECT_NE(list.out.find("sapling\naab"), std::string::npos) << list.out;
    EXPECT_NE(list.out.find("(broken: see edaha check)"), std::string::npos) << list.out;
    const auto json = nlohmann::json::parse(run_edaha({"styles", "--json"}, "", folder.path()).out);
    EXPECT_EQ(json[0]["title"], "sapling");
    EXPECT_EQ(json[1]["broken"], true);
}

TEST(Cli, FilesAreChecked) {
    const test::TemporaryFolder folder;
    const std::string good = folder / "good.xml";
    const std::string bad = folder / "bad.xml";
    test::write_whole(good, kSapling);
    test::write_whole(bad, "<tree name='x'>\n<growth energy='x'/><q/></tree>");
    EXPECT_EQ(run_edaha({"check", good}).code, 0);
    const Output output = run_edaha({"check", good, bad});
    EXPECT_EQ(output.code, 1);
    EXPECT_EQ(output.out, bad + ":2:9: growth.energy: 'x' is not a number (expected 1 … 1e6)\n" +
                              bad + ":2:22: q: no such group\n");
}

TEST(Cli, ParametersAreExplained) {
    EXPECT_EQ(run_edaha({"explain", "look.wood"}).out,
              "look.wood: filled limbs, one filled shape, contours, or centre lines\n"
              "  value    choice: solid, silhouette, outline or line\n"
              "  default  solid\n"
              "  source   Edaha\n");
    const Output all = run_edaha({"explain"});
    const auto json = nlohmann::json::parse(run_edaha({"explain", "--json"}).out);
    std::size_t explained = parameters().size();
    for (const ParameterList& list : parameter_lists())
        explained += list.parameters.size();
    EXPECT_EQ(json.size(), explained);
    for (const Parameter& parameter : parameters())
        EXPECT_NE(all.out.find("  " + parameter.key() + ' '), std::string::npos) << all.out;
    EXPECT_EQ(run_edaha({"explain", "growt"}).err,
              "edaha: growt: no such group (did you mean 'growth'?)\n");
    EXPECT_EQ(run_edaha({"explain", "growth.enery"}).err,
              "edaha: growth.enery: no such parameter (did you mean 'growth.energy'?)\n");
}

}  // namespace
}  // namespace edaha
