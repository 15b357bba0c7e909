// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/program.h"

namespace edaha {
namespace {

constexpr const char* kGallery =
    "<gallery title='Saplings'>\n"
    " <page name='trees' title='Trees'>\n"
    "  <picture name='one' style='sapling.xml' seed='1' caption='One'/>\n"
    "  <picture name='two' style='sapling.xml' seed='2' caption='Two'/>\n"
    "  <strip name='both' style='sapling.xml'><picture seed='1'/><picture seed='2'/></strip>\n"
    " </page>\n"
    "</gallery>\n";

// Each test makes a gallery of two small trees in an empty folder of its own.
class GalleryCommand : public test::Program {
  protected:
    void SetUp() override {
        std::filesystem::create_directory(folder_ / "gallery");
        write("gallery/gallery.xml", kGallery);
        write("gallery/sapling.xml",
              "<tree name='sapling'><growth energy='15'/><leaf shape='dot.svg'/></tree>");
        write("gallery/dot.svg",
              "<svg xmlns='http://www.w3.org/2000/svg' width='4' height='4'>"
              "<path d='M0 0h4v4z'/></svg>");
    }

    // One character of it, the last of what `part` says.
    void spoil(const std::string& name, const std::string& part) const {
        std::string text = read(name);
        text.at(text.find(part) + part.size() - 1) ^= 1;
        write(name, text);
    }
};

TEST_F(GalleryCommand, DrawsAllThenNothing) {
    expect("edaha gallery", 0, "", "edaha: drew 3 of 3 pictures\n");
    expect("edaha gallery", 0, "", "edaha: drew 0 of 3 pictures\n");
    expect("cd gallery && ls -d *.md *.html trees/*", 0,
           "README.md\nindex.html\ntrees.md\ntrees/both.png\ntrees/both.svg\ntrees/one.png\n"
           "trees/one.svg\ntrees/two.png\ntrees/two.svg\n",
           "");
    expect("edaha gallery --check", 0, "", "");
    expect("edaha gallery --all", 0, "", "edaha: drew 3 of 3 pictures\n");
}

TEST_F(GalleryCommand, DrawsOnlyWhatChanged) {
    sh("edaha gallery");
    std::string text = kGallery;
    text.replace(text.find("seed='2' caption"), 8, "seed='5'");
    write("gallery/gallery.xml", text);
    expect("edaha gallery --json", 0,
           "{\n  \"file\": \"gallery/gallery.xml\",\n  \"pictures\": 3,\n  \"drawn\": [\n"
           "    \"trees/two.svg\"\n  ],\n  \"written\": [\n    \"trees.md\",\n    \"index.html\"\n"
           "  ],\n  \"stale\": [],\n  \"warnings\": []\n}\n",
           "");
    write("gallery/dot.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='4' height='4'>"
          "<path d='M0 0h4v3z'/></svg>");
    expect("edaha gallery", 0, "", "edaha: drew 3 of 3 pictures\n");
    std::filesystem::remove(folder_ / "gallery/trees/one.png");
    expect("edaha gallery", 0, "", "edaha: drew 1 of 3 pictures\n");
}

TEST_F(GalleryCommand, CheckNamesEachFileThatDiffers) {
    sh("edaha gallery");
    spoil("gallery/trees/one.svg", "fill=\"#");
    spoil("gallery/trees/two.png", "Recipe");
    spoil("gallery/README.md", "# S");
    std::filesystem::remove(folder_ / "gallery/trees/both.svg");
    write("gallery/trees/three.svg", "<svg/>");
    const std::string readme = read("gallery/README.md");
    expect("edaha gallery --check", 1,
           "gallery/trees/both.svg: is missing\n"
           "gallery/trees/one.svg: is not what is drawn now\n"
           "gallery/trees/two.png: is not what is drawn now\n"
           "gallery/README.md: is not what is drawn now\n"
           "gallery/trees/three.svg: is not of this gallery\n",
           "");
    EXPECT_EQ(read("gallery/README.md"), readme);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "gallery/trees/both.svg"));
}

TEST_F(GalleryCommand, CheckSeesOtherPixels) {
    sh("edaha gallery && cp gallery/trees/one.png gallery/trees/two.png");
    expect("edaha gallery --check", 1, "gallery/trees/two.png: is not what is drawn now\n", "");
}

TEST_F(GalleryCommand, TheShownCommandDrawsTheVeryFile) {
    sh("edaha gallery");
    expect(
        "cd gallery && grep -c 'edaha draw sapling.xml --seed 2' trees.md && "
        "edaha draw sapling.xml --seed 2 -o again.svg && cmp again.svg trees/two.svg",
        0, "2\n", "");
}

TEST_F(GalleryCommand, BytesDependOnNeitherThreadsNorTheWorkingFolder) {
    sh("cp -r gallery a && cp -r gallery b && edaha gallery a/gallery.xml --jobs 1 && "
       "cd b && edaha gallery gallery.xml --jobs 3");
    expect("edaha gallery \"$PWD/gallery/gallery.xml\" && diff -r gallery a && diff -r gallery b",
           0, "", "edaha: drew 3 of 3 pictures\n");
}

TEST_F(GalleryCommand, WhatIsWrongIsSaidAndNothingDrawn) {
    expect("edaha gallery gone.xml", 1, "",
           "edaha: cannot read 'gone.xml': No such file or directory\n");
    expect("edaha gallery --jobs 0", 2, "",
           "edaha: --jobs: '0' is not a whole number of 1 … 1024\n");
    expect("edaha gallery --chek", 2, "",
           "edaha: gallery: there is no option '--chek' (did you mean '--check'?)\n"
           "Try 'edaha gallery --help'.\n");
    write("gallery/gallery.xml",
          "<gallery title='T'>\n<page name='p' title='P'>\n<picture name='a' style='sapling.xml'/>"
          "\n<picture name='b' style='aok'/>\n<pic/></page></gallery>");
    expect("edaha gallery", 1, "",
           "gallery/gallery.xml:4:19: there is no style 'aok' (did you mean 'oak'?)\n"
           "gallery/gallery.xml:5:2: 'pic' has no place in 'page'\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "gallery/p"));
}

TEST_F(GalleryCommand, TheHelpShowsAGalleryThatCanBeDrawn) {
    expect(
        "edaha gallery --help | sed '1,/^A gallery.xml/d' >help.xml && edaha gallery help.xml && "
        "ls oaks",
        0, "leaning.png\nleaning.svg\nold.png\nold.svg\n", "edaha: drew 2 of 2 pictures\n");
}

TEST_F(GalleryCommand, OurOwnIsWhatIsDrawnNow) {
    if (!std::filesystem::exists(PROJECT_DIR "/gallery/gallery.xml")) GTEST_SKIP();
    expect("cd " + test::quoted(PROJECT_DIR) + " && edaha gallery --check", 0, "", "");
}

TEST_F(GalleryCommand, FilesOfOthersAreLeftAlone) {
    write("gallery/README.md", "My own.");
    expect("edaha gallery", 1, "",
           "edaha: 'gallery/README.md' is there already, and edaha gallery has not written it "
           "(move it "
           "away)\n");
    EXPECT_EQ(read("gallery/README.md"), "My own.");
    EXPECT_FALSE(exists("gallery/trees"));
}

TEST_F(GalleryCommand, AnUnwritableFolderIsOneError) {
    write("gallery/trees", "in the way");
    expect("edaha gallery", 1, "",
           "edaha: cannot make the folder 'gallery/trees': Not a directory\n");
    EXPECT_EQ(read("gallery/trees"), "in the way");
    std::filesystem::remove(folder_ / "gallery/trees");
    if (geteuid() == 0) return;  // who may write everywhere
    expect("chmod 555 gallery && edaha gallery; code=$?; chmod 755 gallery; exit $code", 1, "",
           "edaha: cannot make the folder 'gallery/trees': Permission denied\n");
}

}  // namespace
}  // namespace edaha
