// SPDX-License-Identifier: MIT
#include "write/svg_metadata.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/svg.h"

namespace edaha {
namespace {

std::string svg_of(const Metadata& metadata, bool packed = false) {
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = 10;
    drawing.metadata = metadata;
    std::string text;
    const Sink sink = [&](std::string_view part) { text += part; };
    packed ? write_svgz(drawing, {}, sink) : write_svg(drawing, {}, sink);
    return text;
}

void expect_same(const std::optional<Metadata>& read, const Metadata& written) {
    ASSERT_TRUE(read);
    EXPECT_EQ(read->title, written.title);
    EXPECT_EQ(read->description, written.description);
    EXPECT_EQ(read->command, written.command);
    EXPECT_EQ(read->style_xml, written.style_xml);
    EXPECT_EQ(read->version, written.version);
    EXPECT_EQ(read->recipe, written.recipe);
    EXPECT_EQ(read->seed, written.seed);
}

TEST(SvgMetadata, ComesBackToTheLetter) {
    const Metadata metadata = test::sample_drawing().metadata;
    expect_same(read_svg_metadata(svg_of(metadata)), metadata);
    expect_same(read_svg_metadata(svg_of(metadata, true)), metadata);
}

TEST(SvgMetadata, EvenWhereTheStyleIsHostile) {
    Metadata metadata = test::sample_drawing().metadata;
    metadata.style_xml = "<?xml version=\"1.0\"?>\n<a b='\"&amp;'><![CDATA[ ]]> ]]&gt; </a>  \n\n";
    expect_same(read_svg_metadata(svg_of(metadata)), metadata);
    metadata.style_xml = "</edaha:style></svg>";
    expect_same(read_svg_metadata(svg_of(metadata)), metadata);
}

TEST(SvgMetadata, SurvivesInkscape) {
    const test::TemporaryFolder folder;
    const Drawing drawing = test::sample_drawing();
    std::string text;
    write_svg(drawing, {}, [&](std::string_view part) { text += part; });
    test::write_whole(folder / "in.svg", text);
    const auto result =
        test::run("inkscape --export-type=svg -o " + test::quoted(folder / "out.svg") + ' ' +
                  test::quoted(folder / "in.svg"));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_same(read_svg_metadata(test::read_whole(folder / "out.svg")), drawing.metadata);
}

TEST(SvgMetadata, EmptyPartsAreLeftOut) {
    EXPECT_EQ(svg_of({}).find("<metadata"), std::string::npos);
    Metadata titled;
    titled.title = "Oak";
    const std::string text = svg_of(titled);
    EXPECT_NE(text.find("<dc:title>Oak</dc:title>"), std::string::npos);
    EXPECT_EQ(text.find("edaha:tree"), std::string::npos);
    EXPECT_EQ(read_svg_metadata(text), std::nullopt);
}

TEST(SvgMetadata, OthersFilesHaveNone) {
    EXPECT_EQ(read_svg_metadata(""), std::nullopt);
    EXPECT_EQ(read_svg_metadata("not xml <"), std::nullopt);
    EXPECT_EQ(read_svg_metadata("<svg xmlns='http://www.w3.org/2000/svg'/>"), std::nullopt);
    EXPECT_EQ(read_svg_metadata("<svg><tree seed='1'/></svg>"), std::nullopt);
    EXPECT_EQ(read_svg_metadata("<svg xmlns:t='urn:other'><t:tree seed='1'/></svg>"), std::nullopt);
}

TEST(SvgMetadata, TheNamespaceCountsNotThePrefix) {
    const auto read = read_svg_metadata(
        "<svg xmlns:t='urn:edaha:tree:1'><t:tree t:seed='7' t:version='2'/></svg>");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->seed, 7u);
    EXPECT_EQ(read->version, "2");
}

TEST(SvgMetadata, ASeedThatIsNoneIsNoMetadata) {
    for (const char* seed : {"", "-1", "1x", "18446744073709551616"}) {
        const std::string text =
            std::string("<s xmlns:t='urn:edaha:tree:1'><t:tree t:seed='") + seed;
        EXPECT_EQ(read_svg_metadata(text + "'/></s>"), std::nullopt) << seed;
    }
}

TEST(SvgMetadata, DeepNestingIsHarmless) {
    std::string text;
    for (int i = 0; i < 300000; ++i)
        text += "<g>";
    for (int i = 0; i < 300000; ++i)
        text += "</g>";
    EXPECT_EQ(read_svg_metadata(text), std::nullopt);
}

TEST(SvgMetadata, UnpackingHasALimit) {
    const std::string packed = svg_of(test::sample_drawing().metadata, true);
    EXPECT_THROW(read_svg_metadata(packed, 100), IoError);
}

}  // namespace
}  // namespace edaha
