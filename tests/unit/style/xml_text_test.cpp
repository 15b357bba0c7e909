// SPDX-License-Identifier: MIT
#include "style/xml_text.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

using Bad = std::optional<std::size_t>;

TEST(XmlText, CharactersOfEveryLengthAreText) {
    EXPECT_EQ(first_byte_not_xml(""), Bad());
    EXPECT_EQ(first_byte_not_xml("a\t\r\n\x7f"), Bad());
    EXPECT_EQ(first_byte_not_xml("\xC2\x80 \xDF\xBF"), Bad());
    EXPECT_EQ(first_byte_not_xml("\xE0\xA0\x80 \xEF\xBF\xBD"), Bad());
    EXPECT_EQ(first_byte_not_xml("\xF0\x90\x80\x80 \xF4\x8F\xBF\xBF"), Bad());
}

TEST(XmlText, WhatXmlDoesNotAllowIsFound) {
    EXPECT_EQ(first_byte_not_xml(std::string_view("ab\0", 3)), Bad(2));
    EXPECT_EQ(first_byte_not_xml("a\x1b"), Bad(1));
    EXPECT_EQ(first_byte_not_xml("\xE9t\xE9"), Bad(0));         // Latin-1
    EXPECT_EQ(first_byte_not_xml("a\x80"), Bad(1));             // no lead byte
    EXPECT_EQ(first_byte_not_xml("a\xE8\x91"), Bad(1));         // cut off
    EXPECT_EQ(first_byte_not_xml("\xC1\xBF"), Bad(0));          // overlong, 2 bytes
    EXPECT_EQ(first_byte_not_xml("\xE0\x9F\xBF"), Bad(0));      // overlong, 3 bytes
    EXPECT_EQ(first_byte_not_xml("\xF0\x8F\xBF\xBF"), Bad(0));  // overlong, 4 bytes
    EXPECT_EQ(first_byte_not_xml("\xED\xA0\x80"), Bad(0));      // a surrogate
    EXPECT_EQ(first_byte_not_xml("\xEF\xBF\xBE"), Bad(0));      // U+FFFE
    EXPECT_EQ(first_byte_not_xml("\xF4\x90\x80\x80"), Bad(0));  // beyond U+10FFFF
    EXPECT_EQ(first_byte_not_xml("\xFE\xFF"), Bad(0));          // UTF-16's mark
}

}  // namespace
}  // namespace edaha
