// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/program.h"

namespace edaha {
namespace {

using test::RunResult;

class Binary : public test::Program {};

constexpr const char* kSapling = "<tree name='sapling'><growth energy='20'/></tree>";

TEST_F(Binary, VersionIsOneLine) {
    expect("edaha --version", 0, "edaha " EDAHA_TEST_VERSION "\n", "");
}

TEST_F(Binary, HelpShowsCommandsOptionsAndExamples) {
    const RunResult all = sh("edaha --help");
    EXPECT_EQ(all.exit_code, 0);
    EXPECT_EQ(all.err, "");
    for (const char* line : {"\n  draw  ", "\n  styles  ", "\n  edaha draw cherry -o cherry.svg\n",
                             "\nExit codes: 0 done, 1 failed, 2 wrong use.\n"}) {
        EXPECT_NE(all.out.find(line), std::string::npos) << line << all.out;
    }
    const RunResult draw = sh("edaha draw --help");
    EXPECT_EQ(draw.exit_code, 0);
    for (const char* line : {"\nUsage: edaha draw [OPTIONS] STYLE\n", "\n  --seed N  ",
                             "\n  -o,--output FILE  ", "\nExamples:\n"}) {
        EXPECT_NE(draw.out.find(line), std::string::npos) << line << draw.out;
    }
}

TEST_F(Binary, WrongUseIsCodeTwo) {
    expect("edaha", 2, "", "edaha: a command is missing\nTry 'edaha --help'.\n");
    expect("edaha drwa oak", 2, "",
           "edaha: there is no command 'drwa' (did you mean 'draw'?)\nTry 'edaha --help'.\n");
    expect("edaha draw oak --sede 3", 2, "",
           "edaha: draw: there is no option '--sede' (did you mean '--seed'?)\n"
           "Try 'edaha draw --help'.\n");
    expect("edaha draw oak --set growth.enery=3", 2, "",
           "edaha: --set: growth.enery: no such parameter (did you mean 'growth.energy'?)\n");
    expect("edaha draw oak --seed x", 2, "",
           "edaha: --seed: 'x' is not a whole number (expected 0 … 9007199254740991)\n");
    expect("edaha draw oak -o oak.jpg", 2, "",
           "edaha: --output: the ending of 'oak.jpg' is no format (expected svg, svgz, pdf, png or "
           "eps)\n");
    expect("edaha draw oak --format jpg", 2, "",
           "edaha: --format: 'jpg' is not known (expected svg, svgz, pdf, png or eps)\n");
    expect("edaha draw oak -o - --json", 2, "",
           "edaha: --json and the picture can't both go to standard output\n");
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(Binary, FailureIsCodeOne) {
    expect("edaha draw oka", 1, "", "edaha: there is no style 'oka' (did you mean 'oak'?)\n");
    expect("edaha draw gone.xml", 1, "",
           "edaha: cannot read 'gone.xml': No such file or directory\n");
    expect("edaha draw gone.svg", 1, "",
           "edaha: cannot read 'gone.svg': No such file or directory\n");
    write("bad.xml", "<tree name='bad'>\n <growth energy='abc' typ='A'/>\n</tree>\n");
    expect("edaha draw bad.xml", 1, "",
           "bad.xml:2:10: growth.energy: 'abc' is not a number (expected 1 … 1e6)\n"
           "bad.xml:2:23: growth.typ: no such parameter (did you mean 'type'?)\n");
    EXPECT_FALSE(exists("bad.svg"));
}

TEST_F(Binary, TheDefaultFileIsNotOverwritten) {
    write("my.xml", kSapling);
    expect("edaha draw my.xml", 0, "", "edaha: wrote sapling.svg\n");
    const std::string first = test::read_whole(folder_ / "sapling.svg");
    expect("edaha draw my.xml --seed 2", 1, "",
           "edaha: 'sapling.svg' is there already (--force overwrites it, -o names another)\n");
    EXPECT_EQ(test::read_whole(folder_ / "sapling.svg"), first);
    expect("edaha draw my.xml --seed 2 --force", 0, "", "edaha: wrote sapling.svg\n");
    EXPECT_NE(test::read_whole(folder_ / "sapling.svg"), first);
    expect("edaha draw my.xml -o sapling.svg", 0, "", "");
    EXPECT_EQ(test::read_whole(folder_ / "sapling.svg"), first);
    expect("edaha draw my.xml --format pdf", 0, "", "edaha: wrote sapling.pdf\n");
    EXPECT_TRUE(test::read_whole(folder_ / "sapling.pdf").starts_with("%PDF"));
}

TEST_F(Binary, NamesAreUtf8) {
    std::filesystem::create_directory(folder_ / "枝葉");
    write("枝葉/木.xml", kSapling);
    expect(
        "edaha draw 枝葉/木.xml -o 枝葉/木.svg && cd 枝葉 && edaha draw 木.svg -o 木2.svg && "
        "cmp 木.svg 木2.svg",
        0, "", "");
}

TEST_F(Binary, TheLocaleChangesNothing) {
    write("my.xml", kSapling);
    expect(
        "LC_ALL=C edaha draw my.xml -o a.svg && LC_ALL=de_DE.UTF-8 edaha draw my.xml -o b.svg && "
        "cmp a.svg b.svg",
        0, "", "");
}

TEST_F(Binary, TheUsersFoldersAreSearched) {
    std::filesystem::create_directories(folder_ / ".local/share/edaha/styles");
    std::filesystem::create_directories(folder_ / "data/edaha/styles");
    write(".local/share/edaha/styles/mine.xml", kSapling);
    write("data/edaha/styles/other.xml", kSapling);
    EXPECT_EQ(sh("edaha draw mine -o a.svg").exit_code, 0);
    EXPECT_EQ(sh("XDG_DATA_HOME=\"$PWD/data\" edaha draw other -o b.svg").exit_code, 0);
    expect("edaha draw other -o c.svg", 1, "", "edaha: there is no style 'other'\n");
}

TEST_F(Binary, StylesAreListedForScripts) {
    const RunResult names = sh("edaha styles --names");
    EXPECT_EQ(names.exit_code, 0);
    EXPECT_NE(names.out.find("cherry\n"), std::string::npos);
    EXPECT_EQ(names.out.find(' '), std::string::npos);
    EXPECT_EQ(sh("edaha leaves --names").out.find("apple\n"), 0U);
}

TEST_F(Binary, FailedOutputIsOneMessage) {
    write("my.xml", kSapling);
    expect("edaha draw my.xml -o gone/x.svg", 1, "",
           "edaha: cannot write 'gone/x.svg': No such file or directory\n");
    expect("edaha man >/dev/full", 1, "",
           "edaha: cannot write to standard output: No space left on device\n");
    // The program runs on until the reader is gone.
    const RunResult pipe =
        sh("{ sleep 0.2; edaha explain --markdown; echo $? >code; } | true; cat code");
    EXPECT_EQ(pipe.out, "1\n");
    EXPECT_EQ(pipe.err, "edaha: cannot write to standard output: Broken pipe\n");
}

TEST_F(Binary, AReadOnlyFolderIsSaid) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    std::filesystem::create_directory(folder_ / "locked");
    ::chmod((folder_ / "locked").c_str(), 0555);
    write("my.xml", kSapling);
    expect("edaha draw my.xml -o locked/x.svg", 1, "",
           "edaha: cannot write 'locked/x.svg': Permission denied\n");
}

TEST_F(Binary, CheckedFilesAreNamed) {
    write("good.xml", kSapling);
    expect("edaha check good.xml", 0, "", "");
    write("empty.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
    const RunResult leaf = sh("edaha check good.xml empty.svg");
    EXPECT_EQ(leaf.exit_code, 1);
    EXPECT_TRUE(leaf.out.starts_with("empty.svg:1:")) << leaf.out;
}

TEST_F(Binary, StandardInputIsAStyle) {
    expect("echo \"<tree name='x'><growth energy='5'/></tree>\" | edaha draw - -o x.svg", 0, "",
           "");
    expect("edaha draw - </dev/null", 1, "",
           "standard input:1:1: there is no <tree> in this file\n");
}

}  // namespace
}  // namespace edaha
