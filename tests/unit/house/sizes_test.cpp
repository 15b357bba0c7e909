// SPDX-License-Identifier: MIT
// How large files are, what they are called, and how they begin.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "unit/house/project_text.h"

namespace edaha::test {
namespace {

bool is_name_of_file(const std::string& path) {
    const std::string stem = std::filesystem::path(path).stem().string();
    return std::ranges::all_of(
        stem, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

struct Limits {
    std::size_t longest;
    std::size_t median;  // of src/ alone: tests are lists
};

void expect_short(const std::string& ending, Limits limits) {
    std::vector<std::size_t> sizes;
    for (const TextFile& file : project_files({"src", "tests"}, {ending})) {
        EXPECT_LE(file.lines.size(), limits.longest) << file.path;
        if (file.path.starts_with("src/")) sizes.push_back(file.lines.size());
    }
    ASSERT_GT(sizes.size(), 40U);
    std::ranges::sort(sizes);
    EXPECT_LE(sizes[sizes.size() / 2], limits.median) << ending;
}

TEST(Sizes, HeadersAreShort) {
    expect_short(".h", {150, 50});
}

TEST(Sizes, SourcesAreShort) {
    expect_short(".cpp", {600, 200});
}

TEST(Sources, AreNamedInSnakeCaseAndBeginWithTheLicence) {
    for (const TextFile& file : project_files({"src", "tests"}, {".h", ".cpp"})) {
        ASSERT_FALSE(file.lines.empty()) << file.path;
        EXPECT_EQ(file.lines[0], "// SPDX-License-Identifier: MIT") << file.path;
        EXPECT_TRUE(is_name_of_file(file.path)) << file.path;
    }
}

TEST(Sources, HeadersAreReadOnce) {
    for (const TextFile& file : project_files({"src", "tests"}, {".h"})) {
        ASSERT_GE(file.lines.size(), 2U) << file.path;
        EXPECT_EQ(file.lines[1], "#pragma once") << file.path;
    }
}

}  // namespace
}  // namespace edaha::test
