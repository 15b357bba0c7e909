// SPDX-License-Identifier: MIT
#include "style/xml_tree.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

struct Reading {
    XmlElement root;
    std::string problems;  // one a line
};

Reading read(const std::string& text) {
    XmlProblems problems(text, "a.xml");
    Reading reading{read_xml(text, "book", problems), {}};
    for (const Problem& problem : problems.sorted())
        reading.problems += to_string(problem) + '\n';
    return reading;
}

TEST(XmlTree, KeepsElementsAttributesAndText) {
    const Reading r = read(
        "<?xml version='1.0' encoding='utf-8'?>\n<!-- a -->\n"
        "<book a='1' b='&lt;'>\n  <page/>\n  <page c='x'>one <!-- b -->&amp; "
        "<![CDATA[<two>]]></page>\n"
        "</book>\n<!-- c -->\n");
    EXPECT_EQ(r.problems, "");
    ASSERT_EQ(r.root.attributes.size(), 2U);
    EXPECT_EQ(r.root.attributes[1].value, "<");
    ASSERT_EQ(r.root.children.size(), 2U);
    EXPECT_EQ(r.root.children[0].text, "");
    EXPECT_EQ(r.root.children[1].text, "one & <two>");
    EXPECT_EQ(r.root.children[1].attributes[0].name, "c");
}

TEST(XmlTree, EveryProblemHasItsPlace) {
    EXPECT_EQ(read("<book a='1' b='2' a='3'>\n x<page/>\n</book>\n<book/>").problems,
              "a.xml:1:7: a: is given twice\n"
              "a.xml:2:2: text 'x' has no place beside elements\n"
              "a.xml:4:2: nothing but <book> has a place here\n");
    EXPECT_EQ(read("<!DOCTYPE book><book/>").problems,
              "a.xml:1:11: nothing but <book> has a place here\n");
    EXPECT_EQ(read("<boko/>").problems, "a.xml:1:2: the root element is 'boko' (expected book)\n");
    EXPECT_EQ(read("").problems, "a.xml:1:1: there is no <book> in this file\n");
    EXPECT_EQ(read("<book>\n<page></book>").problems,
              "a.xml:2:9: malformed XML: a start tag and an end tag do not match\n");
    EXPECT_EQ(read("<book>\n\x01</book>").problems, "a.xml:2:1: byte 0x01 is no UTF-8 text\n");
    EXPECT_EQ(read("<book a='&#1;'>&#2;</book>").problems,
              "a.xml:1:2: book: holds what is no text\n"
              "a.xml:1:7: a: '?' is not XML text\n");
    EXPECT_EQ(read("<?xml version='1.0' encoding='latin1'?><book/>").problems,
              "a.xml:1:3: the text must be UTF-8, not 'latin1'\n");
}

TEST(XmlTree, DepthIsLimited) {
    std::string deep;
    for (int i = 0; i < 200; ++i)
        deep += "<book>";
    for (int i = 0; i < 200; ++i)
        deep += "</book>";
    EXPECT_EQ(read(deep).problems, "a.xml:1:608: more than 100 levels deep\n");
}

}  // namespace
}  // namespace edaha
