// SPDX-License-Identifier: MIT
#include "ornament/css.h"

#include <gtest/gtest.h>

namespace edaha::svg {
namespace {

// The last value that wins, as "fill=red stroke=blue" in the order of the sheet.
std::string match(std::string_view sheet, const CssSubject& subject) {
    CssSheet rules;
    rules.add(sheet, 0);
    std::string text;
    for (const CssDeclaration* d : rules.match(subject)) {
        text += (text.empty() ? "" : " ") + d->property + '=' + d->value;
    }
    return text;
}

std::vector<std::string> complaints(std::string_view sheet) {
    CssSheet rules;
    std::vector<std::string> messages;
    for (const CssComplaint& c : rules.add(sheet, 0)) {
        messages.push_back(std::to_string(c.offset) + ' ' + c.message);
    }
    return messages;
}

TEST(Css, DeclarationsKeepTheirPlaces) {
    std::vector<CssComplaint> found;
    const auto declared =
        read_declarations(" fill : red ;/*x;*/Stroke:url(a;b)!important; ;", found);
    ASSERT_EQ(declared.size(), 2U);
    EXPECT_EQ(declared[0].property, "fill");
    EXPECT_EQ(declared[0].value, "red");
    EXPECT_EQ(declared[0].offset, 8U);
    EXPECT_EQ(declared[1].property, "stroke");
    EXPECT_EQ(declared[1].value, "url(a;b)");
    EXPECT_TRUE(declared[1].important);
    EXPECT_TRUE(found.empty());
    read_declarations("fill:red; stroke", found);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].offset, 10U);
    EXPECT_EQ(found[0].message, "style: 'stroke' is not a declaration (expected property: value)");
}

TEST(Css, SelectorsOfOnePieceMatch) {
    const CssSubject leaf{"path", "tip", {"green", "old"}};
    EXPECT_EQ(match("path{a:1}.green{b:2}#tip{c:3}*{d:4}", leaf), "d=4 a=1 b=2 c=3");
    EXPECT_EQ(match("path.old{a:1} .green.old{b:2} path#tip.old{c:3}", leaf), "a=1 b=2 c=3");
    EXPECT_EQ(match("rect{a:1}.young{b:2}#root{c:3}.green.young{d:4}", leaf), "");
    EXPECT_EQ(match(".x,.old , #y{a:1}", leaf), "a=1");
}

TEST(Css, TheMoreSpecificComesLast) {
    const CssSubject leaf{"path", "tip", {"green", "old"}};
    EXPECT_EQ(match("#tip{a:1}.green.old{a:2}.green{a:3}path{a:4}", leaf), "a=4 a=3 a=2 a=1");
    EXPECT_EQ(match(".old{a:1}.green{a:2}", leaf), "a=1 a=2");
}

TEST(Css, CommentsAreSkipped) {
    const CssSubject leaf{"path", "", {"a"}};
    EXPECT_EQ(match("<!-- /* .b{} */ .a{/**/x:1;/*}*/y:2} -->", leaf), "x=1 y=2");
    EXPECT_EQ(match(".a{x:1", leaf), "x=1");
}

TEST(Css, WhatIsBeyondItIsNamed) {
    using List = std::vector<std::string>;
    EXPECT_EQ(complaints("g path{a:1}"),
              List{"0 style sheet: 'g path' is a selector beyond element, .class and #id, and left "
                   "out"});
    EXPECT_EQ(complaints(".a:hover , .b{a:1}").size(), 1U);
    EXPECT_EQ(complaints("@import url(x.css); .a{a:1}"),
              List{"0 style sheet: '@import' is left out"});
    EXPECT_EQ(complaints("@media print{.a{a:1}} .b{b:1}"),
              List{"0 style sheet: '@media' is left out"});
    EXPECT_EQ(complaints(".a{a:1} junk"),
              List{"8 style sheet: 'junk' is left out (expected rules with { })"});
    EXPECT_EQ(match("@media print{.a{a:1}} .a{b:1}", {"path", "", {"a"}}), "b=1");
}

}  // namespace
}  // namespace edaha::svg
