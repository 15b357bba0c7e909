// SPDX-License-Identifier: MIT
#include "write/xml_text.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

TEST(XmlText, KeepsWhatIsText) {
    const std::string text = "Tab\tline\n<&> 枝葉 \xf0\x9f\x8c\xb3";
    EXPECT_EQ(xml_safe(text), text);
}

TEST(XmlText, LeavesOutControlCharacters) {
    EXPECT_EQ(xml_safe(std::string("a\0b\x01\x1b[0m\x7f", 9)), "ab[0m\x7f");
    EXPECT_EQ(xml_safe("\xef\xbf\xbe!"), "!");  // U+FFFE
}

TEST(XmlText, ReplacesWhatIsNoUtf8) {
    const std::string replaced = "\xef\xbf\xbd";
    EXPECT_EQ(xml_safe("a\xff"
                       "b"),
              "a" + replaced + "b");
    EXPECT_EQ(xml_safe("\xe6\x9e"), replaced + replaced);                 // cut short
    EXPECT_EQ(xml_safe("\xc0\xaf"), replaced + replaced);                 // overlong
    EXPECT_EQ(xml_safe("\xed\xa0\x80"), replaced + replaced + replaced);  // surrogate
    EXPECT_EQ(xml_safe("\xf4\x90\x80\x80").size(), 4 * replaced.size());  // above U+10FFFF
}

std::string appended(std::string_view text, XmlPlace place) {
    std::string to = "to: ";
    append_xml(to, text, place);
    return to;
}

TEST(XmlText, IsEscapedAsItsPlaceAsksFor) {
    EXPECT_EQ(appended("a<b>\"c\" & 'd'\t\n", XmlPlace::text), "to: a&lt;b&gt;\"c\" &amp; 'd'\t\n");
    EXPECT_EQ(appended("a<b>\"c\" & 'd'\t\n\r", XmlPlace::attribute),
              "to: a&lt;b>&quot;c&quot; &amp; 'd'&#09;&#10;&#13;");
    EXPECT_EQ(appended("", XmlPlace::text), "to: ");
}

TEST(XmlText, IsMadeSafeBeforeItIsEscaped) {
    const std::string hostile("\x1b[0m \xff 枝\0<", 13);
    for (const XmlPlace place : {XmlPlace::text, XmlPlace::attribute})
        EXPECT_EQ(appended(hostile, place), "to: [0m \xef\xbf\xbd 枝&lt;");
}

}  // namespace
}  // namespace edaha
