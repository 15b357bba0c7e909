// SPDX-License-Identifier: MIT
#include "app/batch/journal.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/run.h"

namespace edaha {
namespace {

using test::TemporaryFolder;

std::string row(const std::string& file, const std::string& recipe, int branches) {
    return R"({"file":")" + file + R"(","width_mm":1.5,"height_mm":2,"branches":)" +
           std::to_string(branches) +
           R"(,"leaves":2,"overlap":0.25,"nodes":3,"bytes":4,"recipe":")" + recipe + "\"}";
}

TEST(Journal, GivesTheLinesOfThisRun) {
    const TemporaryFolder folder;
    {
        Journal journal(folder / "j", false);
        journal.append("earlier");
    }
    Journal journal(folder / "j", true);
    journal.begin_run();
    const std::string large(100000, 'x');
    journal.append("a");
    journal.append(large);
    EXPECT_EQ(journal.next_line(), "a");
    EXPECT_EQ(journal.next_line(), large);
    EXPECT_EQ(journal.next_line(), std::nullopt);
    EXPECT_TRUE(journal.knows_earlier_rows());
    EXPECT_EQ(test::read_whole(folder / "j"), "earlier\na\n" + large + "\n");
}

TEST(Journal, WithoutKeepingItStartsEmpty) {
    const TemporaryFolder folder;
    test::write_whole(folder / "j", "old\n");
    Journal journal(folder / "j", false);
    journal.begin_run();
    EXPECT_FALSE(journal.knows_earlier_rows());
    EXPECT_EQ(journal.next_line(), std::nullopt);
    journal.remove();
    EXPECT_FALSE(std::filesystem::exists(folder / "j"));
}

TEST(Journal, FindsRowsByFileAndRecipe) {
    const TemporaryFolder folder;
    // The last line is torn at every byte in turn: it must never be half known.
    const std::string whole = row("a", "1", 5) + '\n' + row("a", "2", 6) + '\n';
    const std::string last = row("b", "1", 7) + '\n';
    for (std::size_t size = 0; size <= last.size(); ++size) {
        test::write_whole(folder / "j", whole + last.substr(0, size));
        Journal journal(folder / "j", true);
        journal.begin_run();
        ASSERT_TRUE(journal.find("a", "1"));
        EXPECT_EQ(journal.find("a", "1")->measures.branches, 5u);
        EXPECT_EQ(journal.find("a", "2")->measures.branches, 6u);
        EXPECT_EQ(journal.find("a", "2")->measures.width_mm, 1.5);
        EXPECT_EQ(journal.find("a", "2")->bytes, 4u);
        EXPECT_FALSE(journal.find("a", "3"));
        EXPECT_FALSE(journal.find("c", "1"));
        EXPECT_EQ(journal.find("b", "1").has_value(), size == last.size());
    }
}

TEST(Journal, LinesThatAreNoRowsAreNotKnown) {
    const TemporaryFolder folder;
    test::write_whole(folder / "j", "[]\nnull\n{\"file\":\"a\"}\n" + std::string(3, '\0') + "\n" +
                                        row("a", "1", 5) + "\n");
    Journal journal(folder / "j", true);
    journal.begin_run();
    EXPECT_TRUE(journal.find("a", "1"));
}

TEST(Journal, TwoWritersAreRefused) {
    const TemporaryFolder folder;
    const Journal first(folder / "j", false);
    try {
        const Journal second(folder / "j", true);
        FAIL();
    } catch (const IoError& error) {
        EXPECT_EQ(error.what(),
                  "cannot write '" + (folder / "j") + "': another edaha batch writes there");
    }
}

TEST(Journal, SaysWhyItCannotWrite) {
    const TemporaryFolder folder;
    try {
        const Journal journal(folder / "no/j", false);
        FAIL();
    } catch (const IoError& error) {
        EXPECT_EQ(error.what(),
                  "cannot write '" + (folder / "no/j") + "': No such file or directory");
    }
}

}  // namespace
}  // namespace edaha
