// SPDX-License-Identifier: MIT
// The gallery's page in a browser: Chromium without a window opens a copy of it, to which probe.js
// is appended, and prints what became of it.
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGallery =
    "<gallery title='Saplings &amp; &quot;&lt;more&gt;&quot;' description='Of *one* kind.'>\n"
    "<page name='trees' title='Trees'><text>Words.</text>\n"
    "<picture name='one' style='sapling.xml' seed='1' caption='One &lt;/script> tree'/>\n"
    "<picture name='two' style='sapling.xml' seed='2' caption='Two'/>\n"
    "<picture name='old' style='older.xml' seed='2' palette='night' background='yes'/>\n"
    "<strip name='both' style='sapling.xml' caption='Both'><picture caption='it&apos;s'/>"
    "<picture seed='2'/></strip></page>\n"
    "<page name='manual' title='Manual'>"
    "<parameters groups='variant page' style='sapling.xml'/>\n"
    "<table><row head='yes'><cell>a</cell></row><row><cell>b</cell></row></table></page>\n"
    "</gallery>\n";

class GalleryPage : public test::Program {
  protected:
    struct Visit {
        std::string complaints;
        std::string console;  // what the browser says on its console
    };

    void SetUp() override {
        write("gallery.xml", kGallery);
        write("sapling.xml", "<tree name='sapling' title='Sapling'><growth energy='12'/></tree>");
        write("older.xml",
              "<tree name='older' title='Older' extends='sapling.xml'><growth energy='20'/>"
              "<palette name='night' paper='#101418'/></tree>");
    }

    // Opens the page in `folder`, with `more` appended, in a window of that many pixels.
    Visit visit(const std::string& folder, const std::string& more, const std::string& size) const {
        const std::string page = "probe-" + size + ".html";
        const std::string probe = test::read_whole(TESTS_DIR "/browser/probe.js");
        write(folder + page,
              read(folder + "index.html") + more + "<script>\n" + probe + "</script>");
        const test::RunResult result =
            sh("timeout 100 chromium --headless --no-sandbox --disable-gpu --disable-quic "
               "--no-first-run --disable-background-networking --disable-component-update "
               "--disable-sync --enable-logging=stderr --user-data-dir=\"$PWD/chromium\" "
               "--window-size=" +
               size + " --virtual-time-budget=60000 --dump-dom " +
               test::quoted("file://" + folder_.path() + '/' + folder + page));
        return {between(result.out, "<pre id=\"probe\">", "</pre>"), console_lines(result.err)};
    }

    static std::string between(const std::string& text, const std::string& open,
                               const std::string& close) {
        const std::size_t begin = text.find(open);
        if (begin == std::string::npos) return "the probe did not end: " + text.substr(0, 500);
        const std::size_t end = text.find(close, begin);
        return text.substr(begin + open.size(), end - begin - open.size());
    }

    static std::string console_lines(const std::string& log) {
        std::string lines;
        std::istringstream in(log);
        for (std::string line; std::getline(in, line);)
            if (line.find("CONSOLE") != std::string::npos) lines += line + '\n';
        return lines;
    }
};

TEST_F(GalleryPage, WorksOnWideAndNarrowScreens) {
    ASSERT_EQ(sh("edaha gallery gallery.xml").exit_code, 0);
    for (const char* size : {"1300,900", "500,900"}) {
        const Visit result = visit("", "", size);
        EXPECT_EQ(result.complaints, "all is well") << size;
        EXPECT_EQ(result.console, "") << size;
    }
}

TEST_F(GalleryPage, WhatIsBrokenIsSeen) {
    ASSERT_EQ(sh("edaha gallery gallery.xml && rm trees/two.png trees/both.svg").exit_code, 0);
    const Visit broken = visit("", "", "1300,900");
    EXPECT_EQ(broken.complaints,
              "another size than it says: trees/two.png\n"
              "no picture: trees/both.svg\n"
              "no thumbnail: trees/two.png");
    const Visit thrown = visit("", "<script>throw new Error('on purpose');</script>", "1300,901");
    EXPECT_NE(thrown.console.find("on purpose"), std::string::npos);
    const Visit deaf = visit("",
                             "<script>document.getElementById('viewer').showModal = "
                             "function () {};</script>",
                             "1300,902");
    EXPECT_NE(deaf.complaints.find("the viewer is not open"), std::string::npos);
}

TEST_F(GalleryPage, OurOwnWorksToo) {
    const fs::path own = fs::path(PROJECT_DIR) / "gallery";
    if (!fs::exists(own / "index.html")) GTEST_SKIP() << "there is none yet";
    fs::create_directory(folder_ / "own");
    for (const auto& entry : fs::directory_iterator(own))
        fs::create_symlink(entry.path(), folder_ / ("own/" + entry.path().filename().string()));
    const Visit result = visit("own/", "", "1300,900");
    EXPECT_EQ(result.complaints, "all is well");
    EXPECT_EQ(result.console, "");
}

}  // namespace
}  // namespace edaha
