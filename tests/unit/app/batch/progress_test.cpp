// SPDX-License-Identifier: MIT
#include "app/batch/progress.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace edaha {
namespace {

TEST(Progress, LineShowsBarCountRateAndTimeLeft) {
    EXPECT_EQ(progress_line({432, 1000, 128}, 80),
              "[############------------------]   432/1000  128/s  5 s left");
    EXPECT_EQ(progress_line({0, 1000, 0}, 80), "[------------------------------]     0/1000");
    EXPECT_EQ(progress_line({7, 7, 0.5}, 80),
              "[##############################]  7/7  0.5/s  0 s left");
}

TEST(Progress, LineFitsTheTerminal) {
    for (std::size_t columns = 0; columns <= 120; ++columns)
        EXPECT_LE(progress_line({432, 1000, 128}, columns).size(), columns);
    EXPECT_EQ(progress_line({432, 1000, 128}, 40), "[####------]   432/1000  128/s  5 s left");
    EXPECT_EQ(progress_line({432, 1000, 128}, 12), " 432/1000  1");
}

TEST(Progress, DurationsHaveTwoUnits) {
    EXPECT_EQ(duration_text(0), "0 s");
    EXPECT_EQ(duration_text(4.1), "5 s");
    EXPECT_EQ(duration_text(200), "3 min 20 s");
    EXPECT_EQ(duration_text(7500), "2 h 5 min");
}

TEST(Progress, ATerminalGetsAtMostTenLinesASecondAndACleanEnd) {
    std::ostringstream out;
    Progress progress(out, 1000, 80, 100);
    for (int i = 1; i <= 1000; ++i)
        progress.advance(static_cast<std::size_t>(i), 100 + i * 0.001);
    progress.clear();
    const std::string text = out.str();
    EXPECT_NEAR(static_cast<double>(std::ranges::count(text, '[')), 10 * 2 + 1, 3);  // ESC [ K
    EXPECT_TRUE(text.ends_with("\r\x1b[K"));
    EXPECT_EQ(std::ranges::count(text, '\n'), 0);
    EXPECT_NE(text.find("1000/s"), std::string::npos);
}

TEST(Progress, ALogGetsALineEveryFewSeconds) {
    std::ostringstream out;
    Progress progress(out, 100, 0, 0);
    for (int i = 1; i <= 100; ++i)
        progress.advance(static_cast<std::size_t>(i), i * 0.2);
    progress.clear();
    EXPECT_EQ(out.str(),
              "edaha:  25/100  5.0/s  15 s left\n"
              "edaha:  50/100  5.0/s  10 s left\n"
              "edaha:  75/100  5.0/s  5 s left\n"
              "edaha: 100/100  5.0/s  0 s left\n");
}

TEST(Progress, TheRateIsThatOfTheLastSeconds) {
    std::ostringstream out;
    Progress progress(out, 100000, 200, 0);
    progress.advance(50000, 1);  // found, not drawn
    for (int i = 1; i <= 20; ++i)
        progress.advance(static_cast<std::size_t>(50000 + 10 * i), 1 + i);
    EXPECT_NE(out.str().rfind("  10/s  "), std::string::npos);
    EXPECT_GT(out.str().rfind("  10/s  "), out.str().rfind("[#"));
}

TEST(Progress, MessagesStandAboveTheLine) {
    std::ostringstream out;
    Progress progress(out, 10, 80, 0);
    progress.advance(1, 1);
    progress.say("edaha: warning: x");
    EXPECT_TRUE(out.str().ends_with("\r\x1b[Kedaha: warning: x\n"));
}

}  // namespace
}  // namespace edaha
