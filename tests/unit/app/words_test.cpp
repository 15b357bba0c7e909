// SPDX-License-Identifier: MIT
#include "app/gallery/words.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

using Kind = Words::Kind;

TEST(Words, MarksAreRead) {
    const Line line = read_line(" a *b c*\n `d *e*` [f](g.md#h) i ");
    EXPECT_EQ(line, (Line{{Kind::plain, "a "},
                          {Kind::emphasis, "b c"},
                          {Kind::plain, " "},
                          {Kind::code, "d *e*"},
                          {Kind::plain, " "},
                          {Kind::link, "f", "g.md#h"},
                          {Kind::plain, " i"}}));
    EXPECT_EQ(to_plain(line), "a b c d *e* f i");
}

TEST(Words, MarksWithoutPartnersArePlain) {
    for (const std::string text : {"2 * 3 * 4", "a*", "`", "[a] (b)", "[a](", "[]()", "**", "a\\b"})
        EXPECT_EQ(read_line(text), (Line{{Kind::plain, text}})) << text;
    EXPECT_EQ(read_line("\\*a\\* \\[b](c)"), (Line{{Kind::plain, "*a* [b](c)"}}));
    EXPECT_TRUE(read_line(" \n ").empty());
}

TEST(Words, BlankLinesPartParagraphs) {
    const auto paragraphs = read_paragraphs("\n  a\n  b\n \t \n\n c\r\n\r\n");
    ASSERT_EQ(paragraphs.size(), 2U);
    EXPECT_EQ(to_plain(paragraphs[0]), "a b");
    EXPECT_EQ(to_plain(paragraphs[1]), "c");
}

TEST(Words, HtmlIsEscaped) {
    EXPECT_EQ(to_html(read_line("a<b>&\"c\" `<d>` [e](f\"g)")),
              "a&lt;b&gt;&amp;&quot;c&quot; <code>&lt;d&gt;</code> <a href=\"f%22g\">e</a>");
}

TEST(Words, MarkdownOfPlainTextShowsThatText) {
    EXPECT_EQ(to_markdown(read_line("a_b <c> \\*d\\* | &amp;")),
              "a\\_b \\<c\\> \\*d\\* \\| \\&amp;");
    EXPECT_EQ(to_markdown(read_line("# a")), "\\# a");
    EXPECT_EQ(to_markdown(read_line("- a")), "\\- a");
    EXPECT_EQ(to_markdown(read_line("12. a")), "12\\. a");
    EXPECT_EQ(to_markdown(read_line("12 a")), "12 a");
    EXPECT_EQ(to_markdown(read_line("*a* `b` [c](d e)")), "*a* `b` [c](d%20e)");
    EXPECT_EQ(markdown_code("a`b"), "`` a`b ``");
}

TEST(Words, AddressesLeadToPagesOnly) {
    for (const char* good : {"[a](b.md)", "[a](#b)", "[a](https://b.c/d:e)", "[a](http://b)",
                             "[a](mailto:b@c.d)", "[a](b/c:d)", "a:b"}) {
        EXPECT_EQ(unsafe_address(read_line(good)), "") << good;
    }
    EXPECT_EQ(unsafe_address(read_line("[a](javascript:b)")), "javascript:b");
    EXPECT_EQ(unsafe_address(read_line("[a](data:b)")), "data:b");
}

}  // namespace
}  // namespace edaha
