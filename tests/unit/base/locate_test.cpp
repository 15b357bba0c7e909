// SPDX-License-Identifier: MIT
#include "base/locate.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

std::string place(std::string_view text, std::size_t offset) {
    const Place p = place_of_offset(text, offset, "f");
    return std::to_string(p.line) + ':' + std::to_string(p.column);
}

TEST(Locate, LinesAndColumnsCountFromOne) {
    EXPECT_EQ(place("ab\ncd", 0), "1:1");
    EXPECT_EQ(place("ab\ncd", 2), "1:3");
    EXPECT_EQ(place("ab\ncd", 3), "2:1");
    EXPECT_EQ(place("ab\ncd", 99), "2:3");
    EXPECT_EQ(place("", 0), "1:1");
}

TEST(Locate, EveryLineEndingEndsOneLine) {
    EXPECT_EQ(place("a\r\nb", 3), "2:1");
    EXPECT_EQ(place("a\rb", 2), "2:1");
    EXPECT_EQ(place("a\r\n\r\nb", 5), "3:1");
}

TEST(Locate, ColumnsAreCodePoints) {
    EXPECT_EQ(place("葉=x", 4), "1:3");
    EXPECT_EQ(place("\xEF\xBB\xBF<a", 4), "1:2");
}

TEST(Locate, AttributesAreFoundInTheirTag) {
    const std::string_view text = "<a b=\"d='1'>\" c = '2'\n d=\"3\"/><e d=\"4\"/>";
    EXPECT_EQ(text.substr(attribute_offset(text, 1, "d"), 3), "d=\"");
    EXPECT_EQ(text[attribute_value_offset(text, 1, "c")], '2');
    EXPECT_EQ(text[attribute_value_offset(text, 1, "d")], '3');
    EXPECT_EQ(attribute_offset(text, 1, "e"), 1U);
    EXPECT_EQ(attribute_offset("<a", 1, "e"), 1U);
    EXPECT_EQ(attribute_offset("<a b=\"", 1, "e"), 1U);
}

TEST(Locate, ReferencesInAValueCountAsOneByte) {
    const std::string_view text = "M&#10;1\r\n2 3";
    EXPECT_EQ(text[offset_in_value(text, 0, 2)], '1');
    EXPECT_EQ(text[offset_in_value(text, 0, 4)], '2');
    EXPECT_EQ(offset_in_value(text, 0, 99), text.size());
    EXPECT_EQ(offset_in_value("&", 0, 3), 1U);
}

}  // namespace
}  // namespace edaha
