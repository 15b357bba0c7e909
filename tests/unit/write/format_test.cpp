// SPDX-License-Identifier: MIT
#include "write/format.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "support/sample_drawing.h"

namespace edaha {
namespace {

std::string bytes_of(Format format) {
    std::string bytes;
    WriteParams params;
    params.png.width_px = 64;
    const WriteReport report = write_drawing(test::sample_drawing(), format, params,
                                             [&](std::string_view part) { bytes += part; });
    EXPECT_EQ(report.bytes, bytes.size());
    return bytes;
}

TEST(Format, FollowsFromTheEnding) {
    EXPECT_EQ(format_of_file("tree.svg"), Format::svg);
    EXPECT_EQ(format_of_file("a.b/Tree.SVGZ"), Format::svgz);
    EXPECT_EQ(format_of_file("x.y.Pdf"), Format::pdf);
    EXPECT_EQ(format_of_file(".png"), Format::png);
    EXPECT_EQ(format_of_file("tree.eps"), Format::eps);
    for (const char* none :
         {"", "tree", "svg", "tree.", "tree.jpg", "tree.svg.txt", "out.svg/tree"}) {
        EXPECT_EQ(format_of_file(none), std::nullopt) << none;
    }
    for (const Format format : kFormats) {
        EXPECT_EQ(format_of_file("tree." + std::string(name(format))), format);
    }
}

TEST(Format, FilesStartAsTheirFormatsDo) {
    EXPECT_EQ(bytes_of(Format::svg).substr(0, 5), "<?xml");
    EXPECT_EQ(bytes_of(Format::svgz).substr(0, 2), "\x1f\x8b");
    EXPECT_EQ(bytes_of(Format::pdf).substr(0, 8), "%PDF-1.5");
    EXPECT_EQ(bytes_of(Format::png).substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bytes_of(Format::eps).substr(0, 11), "%!PS-Adobe-");
}

TEST(Format, EveryFileRecordsItsRecipe) {
    for (const Format format : kFormats) {
        EXPECT_EQ(recorded_recipe(bytes_of(format), format), "0123456789abcdef") << name(format);
        EXPECT_EQ(recorded_recipe("", format), "") << name(format);
        EXPECT_EQ(recorded_recipe("something else", format), "") << name(format);
        EXPECT_EQ(recorded_recipe(bytes_of(format).substr(0, 60), format), "") << name(format);
        const std::string bytes = bytes_of(format);
        const std::string torn = bytes.substr(0, bytes.size() - 20);
        EXPECT_EQ(recorded_recipe(torn, format), "") << name(format);
    }
}

// More than a second apart: dates have seconds.
TEST(Format, ALaterRunGivesTheSameBytes) {
    std::vector<std::string> before;
    for (const Format format : kFormats)
        before.push_back(bytes_of(format));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    for (std::size_t i = 0; i < kFormats.size(); ++i) {
        EXPECT_TRUE(bytes_of(kFormats[i]) == before[i]) << name(kFormats[i]);
    }
}

}  // namespace
}  // namespace edaha
