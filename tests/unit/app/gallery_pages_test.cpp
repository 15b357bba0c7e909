// SPDX-License-Identifier: MIT
#include "app/gallery/gallery_pages.h"

#include <gtest/gtest.h>

#include "app/gallery/gallery_xml.h"

namespace edaha {
namespace {

std::vector<PageFile> pages_of(const std::string& text) {
    const Catalogue catalogue;
    LeafShelf leaves(catalogue);
    const Gallery gallery = read_gallery({text, "g.xml", {}}, catalogue, leaves);
    const PlateFacts facts{12345, 320, 200, {0xfb, 0xf7, 0xee}};
    return gallery_pages(gallery, std::vector<PlateFacts>(gallery.plates.size(), facts));
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

constexpr const char* kGallery =
    "<gallery title='A &lt;b&gt;' description='*c*'><page name='p' title='P &amp; q'>"
    "<text>See [the rest](q.md) | x.</text>"
    "<picture name='o' style='oak' caption='An &quot;oak&quot; | here'/>"
    "<picture name='f' style='fir'/></page>"
    "<page name='q' title='Q'><table><row head='yes'><cell>h</cell></row>"
    "<row><cell>1|2</cell><cell>`b`</cell></row></table></page></gallery>";

TEST(GalleryPages, OneMarkdownFileAPageAndOneOfHtml) {
    std::vector<std::string> names;
    for (const PageFile& file : pages_of(kGallery))
        names.push_back(file.name);
    EXPECT_EQ(names, (std::vector<std::string>{"README.md", "p.md", "q.md", "index.html"}));
}

TEST(GalleryPages, MarkdownOfAPageToTheLetter) {
    const auto files = pages_of(kGallery);
    EXPECT_EQ(
        files[1].text,
        "<!-- Written by edaha gallery -->\n# P \\& q\n"
        "\nSee [the rest](q.md) \\| x.\n"
        "\n| | |\n|:-:|:-:|\n"
        "| <a href=\"p/o.svg\"><img src=\"p/o.png\" width=\"190\" alt=\"An &quot;oak&quot; \\| "
        "here\"></a> | <a href=\"p/f.svg\"><img src=\"p/f.png\" width=\"190\" alt=\"f\"></a> "
        "|\n"
        "| An \"oak\" \\| here<br>`edaha draw oak` | `edaha draw fir` |\n"
        "\n[A \\<b\\>](README.md)\n");
    EXPECT_EQ(files[2].text,
              "<!-- Written by edaha gallery -->\n# Q\n\n| **h** | |\n|---|---|\n| 1\\|2 | `b` "
              "|\n\n[A \\<b\\>](README.md)\n");
}

TEST(GalleryPages, HtmlIsEscapedAndLeadsToItsOwnSections) {
    const std::string html = pages_of(kGallery).back().text;
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n"));
    EXPECT_TRUE(holds(html, "<title>A &lt;b&gt;</title>"));
    EXPECT_TRUE(holds(html, "<p><em>c</em></p>"));
    EXPECT_TRUE(holds(html, "See <a href=\"#page-q\">the rest</a> | x."));
    EXPECT_TRUE(holds(html, "alt=\"An &quot;oak&quot; | here\""));
    EXPECT_TRUE(holds(html, "data-size=\"12 KB\""));
    EXPECT_FALSE(holds(html, "{{"));
    EXPECT_FALSE(holds(html, "https:"));  // nothing from the network
}

TEST(GalleryPages, TheManualSaysWhatTheTableSays) {
    const auto files = pages_of(
        "<gallery title='T'><page name='m' title='M'><parameters groups='growth' style='winter'>"
        "<for parameter='growth.energy'><set space.cell='9'/></for></parameters></page></gallery>");
    const Parameter& energy = *find_parameter("growth.energy");
    for (const PageFile& file : {files[1], files[2]}) {
        EXPECT_TRUE(holds(file.text, "growth.energy"));
        EXPECT_TRUE(holds(file.text, energy.help));
        EXPECT_TRUE(holds(file.text, energy.source));
        EXPECT_TRUE(holds(file.text, "m/growth-energy.svg"));
        EXPECT_TRUE(holds(file.text, "space.cell=9"));
    }
}

}  // namespace
}  // namespace edaha
