// SPDX-License-Identifier: MIT
#include "write/xml_writer.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <pugixml.hpp>

namespace edaha {
namespace {

template <class Write>
std::string written(bool compact, const Write& write) {
    std::string text;
    const Sink sink = [&](std::string_view piece) { text += piece; };
    XmlWriter xml(sink, compact);
    write(xml);
    const std::size_t bytes = xml.finish();
    EXPECT_EQ(bytes, text.size());
    return text;
}

void write_orchard(XmlWriter& xml) {
    xml.declare();
    xml.open("orchard");
    xml.attribute("owner", "A & \"B\"");
    xml.open("tree");
    xml.plain_attribute("d", "M0 0");
    xml.close();
    xml.text_element("note", "1 < 2");
    xml.text_element("note", "");
    xml.open("row");
    xml.open("tree");
    xml.close();
    xml.close();
    xml.close();
}

TEST(XmlWriter, AnElementALine) {
    EXPECT_EQ(written(false, write_orchard), R"(<?xml version="1.0" encoding="UTF-8"?>
<orchard owner="A &amp; &quot;B&quot;">
 <tree d="M0 0" />
 <note>1 &lt; 2</note>
 <row>
  <tree />
 </row>
</orchard>
)");
}

TEST(XmlWriter, CompactIsOneLine) {
    EXPECT_EQ(written(true, write_orchard),
              R"(<?xml version="1.0" encoding="UTF-8"?>)"
              R"(<orchard owner="A &amp; &quot;B&quot;"><tree d="M0 0"/><note>1 &lt; 2</note>)"
              R"(<row><tree/></row></orchard>)");
}

// A reader of others' is the oracle: all of a text comes back, whatever it holds and however deep.
TEST(XmlWriter, AnythingIsReadBack) {
    std::string every = "\t\n";
    for (char c = ' '; c > 0; ++c)
        every += c;
    every += "枝葉";
    const int depth = 100;
    const std::string text = written(false, [&](XmlWriter& xml) {
        for (int i = 0; i < depth; ++i)
            xml.open("g");
        xml.attribute("value", every);
        xml.text(every);
        for (int i = 0; i < depth; ++i)
            xml.close();
    });
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(text.c_str()));
    pugi::xml_node node = document.first_child();
    for (int i = 1; i < depth; ++i)
        node = node.first_child();
    EXPECT_EQ(node.attribute("value").value(), every);
    EXPECT_EQ(node.text().get(), every);
}

// Pieces are full but for the last, wherever the texts end.
TEST(XmlWriter, LongTextsGoOutInFullPieces) {
    const std::string data(300'001, 'x');
    std::vector<std::size_t> sizes;
    std::string text;
    const Sink sink = [&](std::string_view piece) {
        sizes.push_back(piece.size());
        text += piece;
    };
    XmlWriter xml(sink, true);
    xml.open("g");
    for (int i = 0; i < 1000; ++i) {
        xml.open("path");
        xml.close();
    }
    xml.text_element("long", data);
    xml.close();
    const std::size_t bytes = xml.finish();
    EXPECT_EQ(bytes, text.size());
    ASSERT_GT(sizes.size(), 2u);
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
        EXPECT_EQ(sizes[i], sizes[0]);
    EXPECT_LE(sizes.back(), sizes[0]);
    EXPECT_NE(text.find("<path/><long>" + data + "</long></g>"), std::string::npos);
}

TEST(XmlWriter, WhatTheSinkThrowsComesThrough) {
    const Sink full = [](std::string_view) { throw std::runtime_error("full"); };
    XmlWriter xml(full, true);
    xml.open("g");
    xml.close();
    EXPECT_THROW(xml.finish(), std::runtime_error);
}

}  // namespace
}  // namespace edaha
