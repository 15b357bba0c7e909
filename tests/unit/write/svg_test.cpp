// SPDX-License-Identifier: MIT
#include "write/svg.h"

#include <cmath>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "drawing/check.h"
#include "ornament/path_data.h"
#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/gzip.h"
#include "write/split_path.h"

namespace edaha {
namespace {

std::string svg(const Drawing& drawing, const SvgParams& params = {}) {
    std::string text;
    const SvgReport report =
        write_svg(drawing, params, [&](std::string_view part) { text += part; });
    EXPECT_EQ(report.bytes, text.size());
    return text;
}

Path square(Vec2 corner, double side) {
    Path path;
    path.move_to(corner), path.line_to(corner + Vec2(side, 0)), path.line_to(corner + Vec2(side));
    path.line_to(corner + Vec2(0, side)), path.close();
    return path;
}

Paint filled(Ink ink, float opacity = 1) {
    Paint paint;
    paint.fill = ink;
    paint.fill_opacity = opacity;
    return paint;
}

// A page of 40 x 30 mm with one layer.
Drawing page_with(std::vector<Element> elements, Paint paint = filled(Colour{0, 128, 0})) {
    Drawing drawing;
    drawing.width_mm = 40;
    drawing.height_mm = 30;
    drawing.symbols = {{"leaf", {{"", square({-1, -1}, 2), {}}}}};
    drawing.layers = {{"Leaves behind", paint, std::move(elements)}};
    return drawing;
}

// The text of the layer alone.
std::string layer_text(const Drawing& drawing, SvgParams params = {}) {
    params.compact = true;
    const std::string text = svg(drawing, params);
    const std::size_t start = text.find("<g id=\"Leaves-behind\"");
    return text.substr(start, text.rfind("</svg>") - start);
}

struct Parsed {
    explicit Parsed(const std::string& text) { EXPECT_TRUE(document.load_string(text.c_str())); }
    pugi::xml_document document;
    pugi::xpath_node_set all(const char* xpath) const { return document.select_nodes(xpath); }
    std::string one(const char* xpath) const {
        return document.select_node(xpath).attribute().value();
    }
};

TEST(Svg, ASmallDrawingToTheLetter) {
    Drawing drawing = page_with(
        {Shape{"limb-1", square({1, 2}, 3), {}}, Use{0, Affine(1, 0, 0, 1, 10, 5.5), {}}});
    drawing.metadata.title = "Oak";
    EXPECT_EQ(svg(drawing), R"svg(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" version="1.1" width="40mm" height="30mm" viewBox="0 0 40 30">
 <title>Oak</title>
 <metadata>
  <rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" xmlns:cc="http://creativecommons.org/ns#" xmlns:dc="http://purl.org/dc/elements/1.1/">
   <cc:Work rdf:about="">
    <dc:format>image/svg+xml</dc:format>
    <dc:type rdf:resource="http://purl.org/dc/dcmitype/StillImage" />
    <dc:title>Oak</dc:title>
   </cc:Work>
  </rdf:RDF>
 </metadata>
 <defs>
  <symbol id="leaf" overflow="visible">
   <path d="M-1-1h2v2h-2z" />
  </symbol>
 </defs>
 <g id="Leaves-behind" inkscape:groupmode="layer" inkscape:label="Leaves behind" fill="#008000">
  <path id="limb-1" d="M1 2h3v3H1z" />
  <use xlink:href="#leaf" transform="translate(10 5.5)" />
 </g>
</svg>
)svg");
}

TEST(Svg, PaintIsSaidOnceWhereItIsSet) {
    Group same{"g", filled(Colour{0, 128, 0}), {Shape{"", square({1, 1}, 2), {}}}};
    EXPECT_EQ(layer_text(page_with({same})),
              R"(<g id="Leaves-behind" inkscape:groupmode="layer" inkscape:label="Leaves behind" )"
              R"(fill="#008000"><g id="g"><path d="M1 1h2v2H1z"/></g></g>)");
    Group other{"",
                filled(Colour{255, 0, 0}, 0.5f),
                {Shape{"", square({1, 1}, 2), {}}, Use{0, Affine(1, 0, 0, 1, 5, 5), {}}}};
    const std::string text = layer_text(page_with({other}));
    EXPECT_NE(text.find(R"(<g fill="#ff0000" fill-opacity=".5"><path d="M1 1h2v2H1z"/><use xlink)"),
              std::string::npos)
        << text;
}

TEST(Svg, ALayerWithoutFillSaysSo) {
    Paint pen;
    pen.stroke = Colour{1, 2, 3};
    pen.stroke_width_mm = 0.25;
    const std::string text = layer_text(page_with({Shape{"", square({1, 1}, 2), pen}}, {}));
    EXPECT_NE(text.find(R"(fill="none" stroke-linecap="round" stroke-linejoin="round"><path )"
                        R"(d="M1 1h2v2H1z" stroke="#010203" stroke-width=".25"/></g>)"),
              std::string::npos)
        << text;
}

TEST(Svg, DashesAreSaidWhereTheyBeginAndEnd) {
    Paint pen, solid;
    pen.stroke = solid.stroke = Colour{1, 2, 3};
    pen.stroke_width_mm = 0.25;
    pen.dash_mm = 1.5;
    Group group{"", pen, {Shape{"", square({1, 1}, 2), {}}, Shape{"", square({4, 1}, 2), solid}}};
    const Parsed parsed(svg(page_with({group}, {})));
    EXPECT_EQ(parsed.one("//g/g/@stroke-dasharray"), "1.5");
    EXPECT_EQ(parsed.one("//g/g/path[2]/@stroke-dasharray"), "none");
    EXPECT_EQ(parsed.all("//path[1]/@stroke-dasharray").size(), 0U);
}

TEST(Svg, TransformsAreAsShortAsTheyCanBe) {
    const auto transform = [](const Affine& map) {
        return Parsed(svg(page_with({Use{0, map, {}}}))).one("//use/@transform");
    };
    EXPECT_EQ(transform(Affine(1, 0, 0, 1, 0, 0)), "");
    EXPECT_EQ(transform(Affine(1, 0, 0, 1, 3, 0)), "translate(3)");
    EXPECT_EQ(transform(Affine(1, 0, 0, 1, 0, 3)), "translate(0 3)");
    EXPECT_EQ(transform(Affine(1, 1e-9, 0, 1, 3, 4)), "translate(3 4)");
    EXPECT_EQ(transform(Affine(-0.5, 0, 0, 2, 3, 0)), "matrix(-.5 0 0 2 3 0)");
}

TEST(Svg, MatricesHaveTheDigitsThatTheirSymbolNeeds) {
    Drawing drawing = page_with({Use{0, Affine(1 / 3.0, 0, 0, 1 / 3.0, 10, 10), {}}});
    EXPECT_EQ(Parsed(svg(drawing)).one("//use/@transform"), "matrix(.333 0 0 .333 10 10)");
    drawing.symbols[0].shapes[0].path = square({0, 0}, 15);
    EXPECT_EQ(Parsed(svg(drawing)).one("//use/@transform"), "matrix(.33333 0 0 .33333 10 10)");
}

// Every point of every instance lands within a step and a half of where it belongs.
TEST(Svg, InstancesAreAsExactAsThePage) {
    const Drawing drawing = test::sample_drawing();
    const Parsed parsed(svg(drawing));
    const double step = 0.01;  // two decimals, for 120 mm
    const Path leaf = read_path_data(parsed.one("//symbol[@id='leaf']/path[1]/@d"));
    const Path& exact = drawing.symbols[0].shapes[0].path;
    ASSERT_EQ(leaf.points.size(), exact.points.size());
    std::size_t compared = 0;
    const auto uses = parsed.all("//g[@id='Leaves']/use[@xlink:href='#leaf']");
    for (const Element& element : drawing.layers[2].children) {
        const auto* use = std::get_if<Use>(&element);
        if (use == nullptr || use->symbol != 0 || compared >= 16) continue;
        std::istringstream text(uses[compared].node().attribute("transform").value());
        text.ignore(7);  // "matrix("
        double n[6];
        for (double& number : n)
            text >> number;
        ASSERT_TRUE(text);
        const Affine written(n[0], n[1], n[2], n[3], n[4], n[5]);
        for (std::size_t i = 0; i < exact.points.size(); ++i) {
            const Vec2 off = transform(written, leaf.points[i]) -
                             transform(use->page_from_symbol, exact.points[i]);
            EXPECT_LT(std::max(std::abs(off.x), std::abs(off.y)), 1.5 * step);
        }
        ++compared;
    }
    EXPECT_EQ(compared, 16u);
}

TEST(Svg, ExpandedInstancesAreShapes) {
    Drawing drawing = page_with({Use{0, Affine(0, 2, -2, 0, 10, 10), {}}});
    const SvgParams expand{.expand = true};
    EXPECT_NE(layer_text(drawing, expand).find(R"(><path d="M12 8v4H8V8z"/></g>)"),
              std::string::npos)
        << layer_text(drawing, expand);
    const Parsed parsed(svg(test::sample_drawing(), expand));
    EXPECT_TRUE(parsed.all("//use").empty());
    EXPECT_TRUE(parsed.all("//symbol").empty());
    EXPECT_EQ(parsed.all("//g[@id='Leaves']//path").size(), 2u * 28u);
}

TEST(Svg, AStrokeInAnExpandedInstanceGrowsWithIt) {
    Drawing drawing = page_with({Use{0, Affine(3, 0, 0, 3, 10, 10), {}}});
    drawing.symbols[0].shapes[0].paint.stroke = Colour{};
    drawing.symbols[0].shapes[0].paint.stroke_width_mm = 0.5;
    EXPECT_EQ(Parsed(svg(drawing)).one("//symbol/path/@stroke-width"), ".5");
    EXPECT_EQ(Parsed(svg(drawing, {.expand = true})).one("//path/@stroke-width"), "1.5");
}

TEST(Svg, SwatchesAreNamed) {
    EXPECT_TRUE(Parsed(svg(test::sample_drawing())).all("//linearGradient").empty());
    const Parsed parsed(svg(test::sample_drawing(), {.swatches = true}));
    EXPECT_EQ(parsed.all("//linearGradient[@inkscape:swatch='solid']").size(), 3u);
    EXPECT_EQ(parsed.one("//linearGradient[@inkscape:label='Bark, light']/stop/@stop-color"),
              "#866854");
}

TEST(Svg, HasNothingThatOtherProgramsChokeOn) {
    for (const bool expand : {false, true}) {
        const std::string text = svg(test::sample_drawing(), {.expand = expand, .swatches = true});
        const std::string drawn = text.substr(text.find("<defs"));
        for (const char* word :
             {"style=", "class=", "rgb", "var(", "clip", "mask", "filter", " href="}) {
            EXPECT_EQ(drawn.find(word), std::string::npos) << word;
        }
        const Parsed parsed(text);
        for (const auto& found : parsed.all("//@d|//@transform|//@stroke-width|//@fill-opacity")) {
            const std::string numbers = found.attribute().value();
            EXPECT_EQ(numbers.find_first_not_of("0123456789.- MmLlHhVvCcSszmatrixnsle()"),
                      std::string::npos)
                << numbers;
            for (const char* word : {"nan", "inf", "-0 ", " 0.", "-0.", "M0."}) {
                EXPECT_EQ(numbers.find(word), std::string::npos) << numbers;
            }
        }
        std::set<std::string> ids;
        for (const auto& found : parsed.all("//@id")) {
            EXPECT_TRUE(ids.insert(found.attribute().value()).second) << found.attribute().value();
        }
        for (const auto& found : parsed.all("//use/@xlink:href")) {
            EXPECT_TRUE(ids.count(found.attribute().value() + 1)) << found.attribute().value();
        }
    }
}

TEST(Svg, IsWellFormedForXmllint) {
    const test::TemporaryFolder folder;
    Drawing drawing = test::sample_drawing();
    drawing.layers[1].label = "<\"&'> \x01\xff";
    drawing.metadata.command = "edaha draw \xff\x02 ]]> --title '\"<&'";
    test::write_whole(folder / "a.svg", svg(drawing, {.swatches = true}));
    const auto result = test::run("xmllint --noout " + test::quoted(folder / "a.svg"));
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
}

TEST(Svg, LargePathsAreSplitAndReported) {
    Path comb;  // two outlines that don't fit one path
    for (int tooth = 0; tooth < 2; ++tooth) {
        comb.move_to({1.0 + 20 * tooth, 1});
        for (int i = 1; i < 20000; ++i) {
            comb.line_to({1.0 + 20 * tooth + 15 * i / 20000.0, i % 2 ? 2.0 : 1.5});
        }
        comb.line_to({16.0 + 20 * tooth, 25}), comb.close();
    }
    std::string text;
    const SvgReport report = write_svg(page_with({Shape{"comb", comb, {}}}), {.decimals = 6},
                                       [&](std::string_view part) { text += part; });
    EXPECT_EQ(report.split_paths, 1u);
    EXPECT_EQ(report.oversized_paths, 0u);
    const Parsed parsed(text);
    const auto paths = parsed.all("//g[@id='comb']/path");
    ASSERT_EQ(paths.size(), 2u);
    for (const auto& path : paths) {
        EXPECT_LE(read_path_data(path.node().attribute("d").value()).points.size(), kMostPathNodes);
    }
    comb.verbs.erase(comb.verbs.begin() + 20001);  // one subpath now: its second move is a line
    comb.verbs[20001] = Verb::line;
    const SvgReport whole =
        write_svg(page_with({Shape{"comb", comb, {}}}), {.decimals = 6}, [](std::string_view) {});
    EXPECT_EQ(whole.split_paths, 0u);
    EXPECT_EQ(whole.oversized_paths, 1u);
}

TEST(Svg, ShapesBelowTheLastDecimalAreReported) {
    std::string text;
    const SvgReport report =
        write_svg(page_with({Shape{"speck", square({1, 1}, 0.001), {}}}), {.decimals = 2},
                  [&](std::string_view part) { text += part; });
    EXPECT_EQ(report.vanished_shapes, 1u);
    EXPECT_EQ(text.find("speck"), std::string::npos);
}

TEST(Svg, PackedItIsTheSame) {
    std::string packed;
    const SvgReport report =
        write_svgz(test::sample_drawing(), {}, [&](std::string_view part) { packed += part; });
    EXPECT_EQ(report.bytes, packed.size());
    EXPECT_EQ(gunzip(packed, 1 << 20), svg(test::sample_drawing()));
}

}  // namespace
}  // namespace edaha
