// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/run.h"

namespace edaha {
namespace {

using test::run;

// What bash offers for the last of the words.
std::string completed(const std::string& words) {
    const auto result =
        run("bash -c 'PATH=\"$(dirname " EDAHA_BINARY
            "):$PATH\"; source <(edaha completion bash); "
            "COMP_WORDS=(" +
            words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _edaha; echo \"${COMPREPLY[*]}\"'");
    EXPECT_EQ(result.err, "") << words;
    return result.out;
}

TEST(Bash, CompletesCommandsOptionsAndValues) {
    EXPECT_EQ(completed("edaha dr"), "draw\n");
    EXPECT_EQ(completed("edaha draw --pal"), "--palette\n");
    EXPECT_EQ(completed("edaha draw --look sil"), "silhouette\n");
    EXPECT_EQ(completed("edaha draw --format p"), "pdf png\n");
    EXPECT_EQ(completed("edaha draw cherr"), "cherry\n");
    EXPECT_EQ(completed("edaha draw --set growth.en"), "growth.energy=\n");
    EXPECT_EQ(completed("edaha explain space.ce"), "space.cell\n");
    EXPECT_EQ(completed("edaha completion z"), "zsh\n");
    EXPECT_EQ(completed("edaha nothing x"), "\n");
}

TEST(Shells, EveryScriptNamesEveryCommand) {
    for (const char* shell : {"bash", "zsh", "fish"}) {
        const auto script = run(std::string(EDAHA_BINARY " completion ") + shell);
        EXPECT_EQ(script.exit_code, 0);
        for (const char* word : {"draw", "batch", "measure", "styles", "leaves", "check", "explain",
                                 "completion", "man", "palette", "edaha styles --names"}) {
            EXPECT_NE(script.out.find(word), std::string::npos) << shell << ": " << word;
        }
    }
    const auto other = run(EDAHA_BINARY " completion csh");
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_EQ(other.err, "edaha: completion: 'csh' is not known (expected bash, zsh or fish)\n");
}

TEST(Manual, IsCleanRoff) {
    const auto page = run(EDAHA_BINARY " man | groff -man -ww -Tascii | col -b");
    EXPECT_EQ(page.err, "");
    for (const char* text :
         {"NAME\n", "edaha draw [options] STYLE\n", "--set GROUP.NAME=VALUE\n", "EXIT STATUS\n"}) {
        EXPECT_NE(page.out.find(text), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace edaha
