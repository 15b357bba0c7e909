// SPDX-License-Identifier: MIT
// Whatever is wrong with an input, the program says so, writes nothing, and leaves what is there.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "app/cli.h"
#include "support/run.h"

namespace edaha::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const std::string& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(TESTS_DIR "/unit/" + folder))
        files.push_back(entry.path().string());
    std::ranges::sort(files);
    return files;
}

class Malformed : public testing::Test {
  protected:
    void SetUp() override { write_whole(picture_, "what was there"); }

    void expect_refused(const std::string& style, const std::string& culprit) const {
        SCOPED_TRACE(culprit);
        std::istringstream in;
        std::ostringstream out, err;
        Console console{in, out, err, {}};
        const std::vector<std::string> arguments{"draw", style, "-o", picture_};
        EXPECT_EQ(edaha::run(arguments, console), 1);
        EXPECT_EQ(out.str(), "");
        const std::string name = fs::path(culprit).filename().string();
        EXPECT_NE(err.str().find(name), std::string::npos) << err.str();
        EXPECT_EQ(read_whole(picture_), "what was there");
        const auto count = std::distance(fs::directory_iterator(folder_.path()), {});
        EXPECT_LE(count, 2) << "the picture, and a style that uses a leaf";
    }

    TemporaryFolder folder_;
    const std::string picture_ = folder_ / "picture.svg";
};

TEST_F(Malformed, StylesDrawNothing) {
    const auto styles = files_of("style/malformed");
    EXPECT_GE(styles.size(), 20U);
    for (const std::string& style : styles)
        expect_refused(style, style);
}

TEST_F(Malformed, LeavesDrawNothing) {
    const auto leaves = files_of("ornament/malformed");
    EXPECT_GE(leaves.size(), 20U);
    const std::string style = folder_ / "style.xml";
    for (const std::string& leaf : leaves) {
        write_whole(
            style, "<tree name='sapling'><growth energy='20'/><leaf shape='" + leaf + "'/></tree>");
        expect_refused(style, leaf);
    }
}

}  // namespace
}  // namespace edaha::test
