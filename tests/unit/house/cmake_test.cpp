// SPDX-License-Identifier: MIT
// What is built is listed: no globs, and no source that nobody builds.
#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "unit/house/project_text.h"

namespace edaha::test {
namespace {

// Whether `word` stands in the file, alone, outside comments.
bool mentions(const TextFile& file, const std::string& word) {
    for (const std::string& line : file.lines) {
        std::string code = line.substr(0, line.find('#'));
        std::ranges::replace_if(
            code, [](char c) { return c == '(' || c == ')'; }, ' ');
        std::istringstream words(code);
        for (std::string other; words >> other;)
            if (other == word) return true;
    }
    return false;
}

TEST(CMake, NamesItsFilesWithoutGlobs) {
    const auto files = project_files({"src", "tests"}, {"CMakeLists.txt", ".cmake"});
    ASSERT_GT(files.size(), 10U);
    for (const TextFile& file : files) {
        EXPECT_FALSE(mentions(file, "GLOB")) << file.path;
        EXPECT_FALSE(mentions(file, "GLOB_RECURSE")) << file.path;
    }
}

TEST(CMake, EverySourceIsBuilt) {
    std::map<std::string, TextFile> lists;  // by folder
    for (TextFile& list : project_files({"src", "tests"}, {"CMakeLists.txt"}))
        lists[std::filesystem::path(list.path).parent_path().string()] = list;
    for (const TextFile& source : project_files({"src", "tests"}, {".cpp"})) {
        const std::filesystem::path path = source.path;
        const std::string folder = path.parent_path().string();
        ASSERT_TRUE(lists.contains(folder)) << folder << " has no CMakeLists.txt";
        EXPECT_TRUE(mentions(lists[folder], path.filename().string())) << source.path;
    }
}

TEST(CMake, MissingSourcesAreFound) {
    const TextFile list{"CMakeLists.txt",
                        split_lines("edaha_room(a SOURCES limb_curve.cpp\n  b.cpp # c.cpp\n)")};
    EXPECT_TRUE(mentions(list, "limb_curve.cpp"));
    EXPECT_TRUE(mentions(list, "b.cpp"));
    EXPECT_FALSE(mentions(list, "curve.cpp"));
    EXPECT_FALSE(mentions(list, "c.cpp"));
}

}  // namespace
}  // namespace edaha::test
