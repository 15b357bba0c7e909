// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "read_leaf_file.h"

namespace edaha {
namespace {

const std::string kFolder = TESTS_DIR "/unit/ornament/malformed/";

// The messages of each file of malformed/, to the letter.
const std::map<std::string, std::string> kMessages = {
    {"bad-colour",
     "bad-colour.svg:2:27: fill: 'grean' is not a colour (did you mean 'green'?)\n"
     "bad-colour.svg:3:24: stroke: '#12345' is not a colour (expected #rgb or #rrggbb)\n"
     "bad-colour.svg:4:29: fill: the end comes too early (expected rgb(r, g, b))\n"
     "bad-colour.svg:4:37: stroke: 'blurple' is not a colour (did you mean 'purple'?)"},
    {"bad-flag", "bad-flag.svg:2:23: path d: '2' is not a flag (expected 0 or 1)"},
    {"bad-length",
     "bad-length.svg:2:29: circle r: 'en' is not a unit (expected mm, cm, in, pt, pc or px)\n"
     "bad-length.svg:3:12: rect x: 'one' is not a length (expected a number)\n"
     "bad-length.svg:3:35: rect height: '-2' is negative (expected 0 or more)\n"
     "bad-length.svg:4:16: ellipse rx: '' is not a length (expected a number)\n"
     "bad-length.svg:5:23: stroke-width: '-1' is negative (expected 0 or more)"},
    {"bad-opacity",
     "bad-opacity.svg:3:22: opacity: 'half' is not a number (expected 0 to 1)\n"
     "bad-opacity.svg:4:24: fill-rule: 'evenod' is not a known value (did you mean 'evenodd'?)"},
    {"bad-transform",
     "bad-transform.svg:2:17: g transform: 'translte' is not a transform (did you mean "
     "'translate'?)\n"
     "bad-transform.svg:3:26: g transform: 'rotate' has 2 numbers (expected 1 or 3)\n"
     "bad-transform.svg:4:24: g transform: '1' is not '(' (expected numbers in parentheses)"},
    {"bad-view-box",
     "bad-view-box.svg:1:15: svg viewBox: '0 0 0 10' has no size (expected a positive width and "
     "height)"},
    {"broken-attribute", "broken-attribute.svg:2:11: XML: this attribute is not name=\"value\""},
    {"circular-use",
     "circular-use.svg:2:24: use: '#b' would draw itself without end\n"
     "circular-use.svg:3:45: use: '#a' would draw itself without end"},
    {"empty", "empty.svg:1:1: XML: there is no element (expected <svg>)"},
    {"empty-stem",
     "empty-stem.svg:3:4: stem: 'g' has no place (expected a point: a small circle or a path)"},
    {"far-away", "far-away.svg:2:56: path: it lies beyond 1e12 units (is a transform wrong?)"},
    {"flat",
     "flat.svg:1:2: the drawing is 8 wide and 0 tall (expected taller than a thousandth of the "
     "width)"},
    {"huge-number", "huge-number.svg:2:17: path d: '1e10' is too large (expected at most 1e9)"},
    {"mismatched", "mismatched.svg:2:27: XML: '</h>' does not end the element that is open"},
    {"missing-coordinate",
     "missing-coordinate.svg:3:12: path d: 'Z' is not a number (expected x1 y1 x2 y2 x y)"},
    {"missing-use",
     "missing-use.svg:3:14: use: '#lobes' is not an id of this file (did you mean '#lobe'?)\n"
     "missing-use.svg:4:20: use: '#vein' is not an id of this file\n"
     "missing-use.svg:5:4: use: there is no href (expected href=\"#id\")"},
    {"no-moveto", "no-moveto.svg:2:12: path d: 'L' comes first (expected M or m)"},
    {"no-shape", "no-shape.svg:1:2: nothing is drawn (expected a filled or stroked shape)"},
    {"not-svg", "not-svg.svg:1:2: 'html' is not an SVG drawing (expected <svg>)"},
    {"not-xml", "not-xml.svg:2:1: XML: there is no element (expected <svg>)"},
    {"odd-points",
     "odd-points.svg:2:29: polygon points: the end is not a number (expected x,y of every point)"},
    {"path-ends", "path-ends.svg:2:19: path d: the end is not a number (expected x y)"},
    {"too-deep", "too-deep.svg:2:599: 'g' is nested 201 deep (expected at most 200)"},
    {"too-many-shapes", "too-many-shapes.svg:2:4: there are more than 10000 shapes"},
    {"too-much-work",
     "too-much-work.svg:3:151: the drawing is too large with all <use> and styles written out "
     "(expected "
     "at most 67108864 bytes)"},
    {"unclosed", "unclosed.svg:3:1: XML: the file ends, but not all its elements do"},
    {"unknown-command",
     "unknown-command.svg:2:22: path d: 'K' is not a command (expected one of M Z L H V C S Q T "
     "A)"},
    {"utf16", "utf16.svg:1:1: the file is not text in UTF-8 (there are zero bytes in it)"},
};

TEST(MalformedLeaf, EveryMessageIsToTheLetter) {
    for (const auto& [name, message] : kMessages) {
        try {
            read_leaf(text_of_file(kFolder + name + ".svg"), name + ".svg");
            ADD_FAILURE() << name << " was read";
        } catch (const InputError& error) {
            EXPECT_EQ(error.what(), message);
        }
    }
}

TEST(MalformedLeaf, EveryFileHasItsMessage) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        EXPECT_TRUE(kMessages.contains(entry.path().stem().string())) << entry.path();
        ++files;
    }
    EXPECT_EQ(files, kMessages.size());
}

TEST(MalformedLeaf, AFileBeyondTheLimitIsRefused) {
    const std::string large = "<svg>" + std::string(8U << 20U, ' ') + "</svg>";
    try {
        read_leaf(large, "large.svg");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "large.svg:1:1: the file has 8388619 bytes (expected at most 8388608)");
    }
}

TEST(MalformedLeaf, TooManyPointsAreRefused) {
    std::string path = "<svg><path d='M0 0";
    for (int i = 0; i < 1'000'000; ++i)
        path += "h1";
    try {
        read_leaf(path + "v9z'/></svg>", "long.svg");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "long.svg:1:7: there are more than 1000000 points");
    }
}

TEST(MalformedLeaf, RulesTimesElementsAreBounded) {
    std::string text = "<svg><style>";
    for (int i = 0; i < 2000; ++i)
        text += "*{fill:red}";
    text += "</style>";
    for (int i = 0; i < 2000; ++i)
        text += "<path d='M0 0H4V4Z'/>";
    EXPECT_THROW(read_leaf(text + "</svg>", "rules.svg"), InputError);
}

}  // namespace
}  // namespace edaha
