// SPDX-License-Identifier: MIT
#include "ornament/path_data.h"

#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "ornament/scan.h"

namespace edaha {
namespace {

// "M 0 0 L 1 2 Z": absolute, cubics written out.
std::string text_of(const Path& path) {
    std::string text;
    const Vec2* p = path.points.data();
    for (const Verb verb : path.verbs) {
        const int count = verb == Verb::close ? 0 : verb == Verb::cubic ? 3 : 1;
        text += (text.empty() ? "" : " ") + std::string(1, "MLCZ"[static_cast<int>(verb)]);
        for (const Vec2* end = p + count; p != end; ++p)
            text += fmt::format(" {:g} {:g}", p->x, p->y);
    }
    return text;
}

std::string reread(std::string_view data) {
    return text_of(read_path_data(data));
}

std::string fault(std::string_view data) {
    try {
        return "no fault: " + reread(data);
    } catch (const SyntaxError& error) {
        return fmt::format("{}: {}", error.offset(), error.what());
    }
}

TEST(PathData, EveryCommandIsReadInBothForms) {
    EXPECT_EQ(reread("M1 2L3 4H5V6Z"), "M 1 2 L 3 4 L 5 4 L 5 6 Z");
    EXPECT_EQ(reread("m1 2l2 2h2v2z"), "M 1 2 L 3 4 L 5 4 L 5 6 Z");
    EXPECT_EQ(reread("M1 1C1 2 3 4 5 6"), "M 1 1 C 1 2 3 4 5 6");
    EXPECT_EQ(reread("m1 1c0 1 2 3 4 5"), "M 1 1 C 1 2 3 4 5 6");
    EXPECT_EQ(reread("M0 0C1 2 3 4 5 4S8 9 6 6"), "M 0 0 C 1 2 3 4 5 4 C 7 4 8 9 6 6");
    EXPECT_EQ(reread("m0 0c1 2 3 4 5 4s3 5 1 2"), "M 0 0 C 1 2 3 4 5 4 C 7 4 8 9 6 6");
    EXPECT_EQ(reread("M0 0Q3 3 6 0T12 0"), "M 0 0 C 2 2 4 2 6 0 C 8 -2 10 -2 12 0");
    EXPECT_EQ(reread("m0 0q3 3 6 0t6 0"), "M 0 0 C 2 2 4 2 6 0 C 8 -2 10 -2 12 0");
    EXPECT_EQ(reread("M0 0A0 1 0 0 0 3 4a0 1 0 0 0 1 1"), "M 0 0 L 3 4 L 4 5");
}

TEST(PathData, SmoothCurvesMirrorOnlyTheirOwnKind) {
    EXPECT_EQ(reread("M1 1S3 3 5 5"), "M 1 1 C 1 1 3 3 5 5");
    EXPECT_EQ(reread("M0 0Q3 3 6 0S8 8 9 9"), "M 0 0 C 2 2 4 2 6 0 C 6 0 8 8 9 9");
    EXPECT_EQ(reread("M0 0C1 1 2 2 3 3T6 3"), "M 0 0 C 1 1 2 2 3 3 C 3 3 4 3 6 3");
    EXPECT_EQ(reread("M3 3T6 3T12 3"), "M 3 3 C 3 3 4 3 6 3 C 8 3 10 3 12 3");
}

TEST(PathData, NumbersMayStandClose) {
    EXPECT_EQ(reread("M1.5.5-2-.5"), "M 1.5 0.5 L -2 -0.5");
    EXPECT_EQ(reread("M1e2-1E-1+3,4."), "M 100 -0.1 L 3 4");
    EXPECT_EQ(reread("\tM 0 , 0\n,1\r\n1 "), "M 0 0 L 1 1");
    EXPECT_EQ(reread("M1e-999 0"), "M 0 0");
    EXPECT_EQ(read_path_data("M0 0a1 1 0 01.5.5").points.back(), Vec2(.5, .5));
    EXPECT_EQ(read_path_data("M0 0a1 1 0 1 0.5.5").points.back(), Vec2(.5, .5));
    EXPECT_EQ(read_path_data("M0 0a1 1 0 00.5.5 1 1 0 10-1-1").points.back(), Vec2(-.5, -.5));
}

TEST(PathData, CommandsRepeat) {
    EXPECT_EQ(reread("m1 1 1 0 0 1"), "M 1 1 L 2 1 L 2 2");
    EXPECT_EQ(reread("M1 1H2 3 4"), "M 1 1 L 2 1 L 3 1 L 4 1");
    EXPECT_EQ(reread("M0 0c1 1 1 1 1 0 1 1 1 1 1 0"), "M 0 0 C 1 1 1 1 1 0 C 2 1 2 1 2 0");
}

TEST(PathData, WhatFollowsACloseBeginsAtItsStart) {
    EXPECT_EQ(reread("M1 1L5 1 5 5ZL0 0"), "M 1 1 L 5 1 L 5 5 Z M 1 1 L 0 0");
    EXPECT_EQ(reread("M1 1l4 0 0 4zm1 1l1 0"), "M 1 1 L 5 1 L 5 5 Z M 2 2 L 3 2");
    EXPECT_EQ(reread("M1 1L2 2zzZ"), "M 1 1 L 2 2 Z");
}

TEST(PathData, EmptyTextIsAnEmptyPath) {
    EXPECT_EQ(reread(""), "");
    EXPECT_EQ(reread(" \n"), "");
    EXPECT_EQ(reread("M3 4"), "M 3 4");
}

TEST(PathData, FaultsSayWhereAndWhat) {
    EXPECT_EQ(fault("L1 1"), "0: 'L' comes first (expected M or m)");
    EXPECT_EQ(fault("M"), "1: the end is not a number (expected x y)");
    EXPECT_EQ(fault("M1,,2"), "3: ',' is not a number (expected x y)");
    EXPECT_EQ(fault("M1 1,L"), "5: 'L' is not a number (expected x y)");
    EXPECT_EQ(fault("M1 1H"), "5: the end is not a number (expected x)");
    EXPECT_EQ(fault("M0 0Zx"), "5: 'x' is not a command (expected one of M Z L H V C S Q T A)");
    EXPECT_EQ(fault("M0 0Z5"), "5: '5' is not a command (expected one of M Z L H V C S Q T A)");
    EXPECT_EQ(fault("M0 0 葉"), "5: '葉' is not a command (expected one of M Z L H V C S Q T A)");
    EXPECT_EQ(fault("M0 0A1 1 0 x"), "11: 'x' is not a flag (expected 0 or 1)");
    EXPECT_EQ(fault("M0 0A1 1 0 0 0 1"),
              "16: the end is not a number (expected rx ry angle large sweep x y)");
    EXPECT_EQ(fault("M0 nan"), "3: 'n' is not a number (expected x y)");
    EXPECT_EQ(fault("M0 1e10"), "3: '1e10' is too large (expected at most 1e9)");
    EXPECT_EQ(fault("M0 -1e999"), "3: '-1e999' is too large (expected at most 1e9)");
}

// Prints random paths in random ways, keeping book of where the pen is.
class RandomWriter {
  public:
    Path expected;
    std::string text;

    void step(int command) {
        const bool relative = *rc::gen::arbitrary<bool>();
        if (expected.empty() || command == 0) {
            begin(relative);
        } else if (command == 1) {
            segment("L", "l", relative, {point()}, [this](auto p) { expected.line_to(p[0]); });
        } else if (command == 2) {
            segment("C", "c", relative, {point(), point(), point()},
                    [this](auto p) { expected.cubic_to(p[0], p[1], p[2]); });
        } else if (command == 3) {
            const double x = point().x;
            letter(relative ? "h" : "H");
            number(relative ? x - at_.x : x);
            at_.x = x;
            expected.line_to(at_);
        } else {
            letter(relative ? "z" : "Z");
            expected.close();
            at_ = start_;
            begin(relative);
        }
    }

  private:
    static Vec2 point() {  // eighths: sums and differences are exact
        return Vec2(*rc::gen::inRange(-999, 999), *rc::gen::inRange(-999, 999)) / 8.0;
    }
    void letter(const std::string& name) {
        text += *rc::gen::element<std::string>("", " ", "\n") + name;
    }
    void number(double value) {
        std::string digits = fmt::format("{}", value);
        if (*rc::gen::arbitrary<bool>()) digits = fmt::format("{:.15e}", value);
        const std::size_t zero = digits.find("0.");
        if (zero == 0 || (zero == 1 && value < 0)) digits.erase(zero, 1);
        const bool follows_number = !text.empty() && (std::isdigit(text.back()) != 0);
        if (follows_number && digits[0] != '-')
            text += *rc::gen::element<std::string>(" ", ",", "\t, ");
        text += digits;
    }
    void begin(bool relative) {
        const Vec2 p = point();
        letter(relative ? "m" : "M");
        number(p.x - (relative ? at_.x : 0));
        number(p.y - (relative ? at_.y : 0));
        expected.move_to(at_ = start_ = p);
    }
    template <typename Draw>
    void segment(const char* large, const char* small, bool relative, std::vector<Vec2> points,
                 Draw&& draw) {
        letter(relative ? small : large);
        for (const Vec2 p : points) {
            number(p.x - (relative ? at_.x : 0));
            number(p.y - (relative ? at_.y : 0));
        }
        draw(points);
        at_ = points.back();
    }

    Vec2 at_{0}, start_{0};
};

TEST(PathData, WhatIsPrintedIsReadBack) {
    const bool holds = rc::check([] {
        RandomWriter writer;
        const auto commands = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5));
        for (const int command : commands)
            writer.step(command);
        const Path path = read_path_data(writer.text);
        RC_ASSERT(path.verbs == writer.expected.verbs);
        RC_ASSERT(path.points == writer.expected.points);
    });
    EXPECT_TRUE(holds);
}

TEST(PathData, RandomTextIsReadOrRefusedInPlace) {
    const bool holds = rc::check([] {
        const auto text = *rc::gen::container<std::string>(
            rc::gen::elementOf(std::string("MmZzLlHhVvCcSsQqTtAa0123456789.-+eE, \nx")));
        try {
            for (const Vec2 p : read_path_data("M0 0" + text).points) {
                RC_ASSERT(std::isfinite(p.x) && std::isfinite(p.y));
            }
        } catch (const SyntaxError& error) {
            RC_ASSERT(error.offset() <= text.size() + 4);
        }
    });
    EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace edaha
