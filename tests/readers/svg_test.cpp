// SPDX-License-Identifier: MIT
// What designers rely on, read back by an XML parser that knows nothing of our writer.
#include <set>

#include <pugixml.hpp>

#include "readers/pictures.h"

namespace edaha::test {
namespace {

class Svg : public EveryStyle {};

// Programs lose or flatten these; files of ours hold none.
constexpr const char* kUnwelcome =
    "//mask | //filter | //clipPath | //style | //svg//svg | //image | //foreignObject | //@style |"
    "//@class | //@href";

void expect_designer_friendly(const pugi::xml_document& document) {
    for (const pugi::xpath_node& found : document.select_nodes(kUnwelcome))
        ADD_FAILURE() << found.node().name() << ' ' << found.attribute().name();
    for (const pugi::xpath_node& found : document.select_nodes("//@fill | //@stroke")) {
        const std::string colour = found.attribute().value();
        const bool is_hex = colour.starts_with('#') && (colour.size() == 7 || colour.size() == 4);
        EXPECT_TRUE(colour == "none" || is_hex) << colour;
    }
}

// Everything that is drawn stands in a layer, which both Inkscape and Illustrator name.
void expect_layers(const pugi::xml_node& svg, const Drawing& drawing) {
    std::vector<std::string> labels;
    for (const pugi::xml_node& node : svg.children()) {
        const std::string name = node.name();
        if (name == "title" || name == "desc" || name == "metadata" || name == "defs") continue;
        EXPECT_EQ(name, "g");
        EXPECT_STREQ(node.attribute("inkscape:groupmode").value(), "layer");
        labels.emplace_back(node.attribute("inkscape:label").value());
        EXPECT_EQ(node.attribute("id").value(), id_from_label(labels.back()));
    }
    std::vector<std::string> expected;
    for (const Layer& layer : drawing.layers)
        expected.push_back(layer.label);
    EXPECT_EQ(labels, expected);
}

void expect_references(const pugi::xml_document& document) {
    std::set<std::string> ids;
    for (const pugi::xpath_node& found : document.select_nodes("//@id")) {
        EXPECT_TRUE(ids.insert(found.attribute().value()).second) << found.attribute().value();
    }
    for (const pugi::xpath_node& found : document.select_nodes("//@xlink:href"))
        EXPECT_TRUE(ids.contains(found.attribute().value() + 1)) << found.attribute().value();
}

void expect_size(const pugi::xml_node& svg) {
    const std::string width = svg.attribute("width").value();
    const std::string height = svg.attribute("height").value();
    ASSERT_TRUE(width.ends_with("mm") && height.ends_with("mm")) << width << ' ' << height;
    EXPECT_EQ(svg.attribute("viewBox").value(), "0 0 " + width.substr(0, width.size() - 2) + ' ' +
                                                    height.substr(0, height.size() - 2));
}

TEST_P(Svg, IsWellFormedAndWhatDesignersRelyOn) {
    for (const std::uint64_t seed : seeds(GetParam())) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Drawing drawing = draw_tree(GetParam(), seed).drawing;
        pugi::xml_document document;
        const auto parsed = document.load_string(in_format(drawing, Format::svg).c_str());
        ASSERT_TRUE(parsed) << parsed.description() << " at byte " << parsed.offset;
        const pugi::xml_node svg = document.document_element();
        ASSERT_STREQ(svg.name(), "svg");
        expect_size(svg);
        expect_layers(svg, drawing);
        expect_references(document);
        expect_designer_friendly(document);
    }
}

INSTANTIATE_TEST_SUITE_P(Styles, Svg, testing::ValuesIn(built_in_styles()), style_test_name);

}  // namespace
}  // namespace edaha::test
