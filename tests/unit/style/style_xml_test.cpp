// SPDX-License-Identifier: MIT
#include "style/style_xml.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "style/parameter.h"
#include "style/value.h"

namespace edaha {
namespace {

const std::string kStyles = TESTS_DIR "/unit/style/styles/";

Style read(const std::string& xml) {
    return read_style({xml, "test.xml", {}}, Catalogue());
}

Style read_file_style(const std::string& name) {
    const Catalogue catalogue;
    return read_style(catalogue.find_style(kStyles + name), catalogue);
}

std::string errors(const std::string& xml) {
    try {
        read(xml);
    } catch (const InputError& error) {
        return error.what();
    }
    return "read";
}

TEST(StyleXml, AnEmptyTreeIsTheDefaultStyle) {
    const Style style = read("<tree name=\"plain\"/>");
    EXPECT_EQ(style.name, "plain");
    EXPECT_EQ(style.title, "plain");
    for (const Parameter& parameter : parameters())
        EXPECT_EQ(value_text(style, parameter), value_text(Style(), parameter)) << parameter.key();
}

TEST(StyleXml, ValuesReachTheStages) {
    const Style style = read_file_style("cherry.xml");
    EXPECT_EQ(style.title, "Cherry");
    EXPECT_EQ(style.description, "Spreading, in full blossom.");
    EXPECT_EQ(style.energy.growth.type, TreeType::b);
    EXPECT_EQ(style.energy.growth.energy, 400);
    EXPECT_EQ(style.energy.branch.right_turn_rad, (Range{radians(20), radians(50)}));
    EXPECT_EQ(style.energy.space.habit_rad, (std::vector{0.0, radians(20), radians(45)}));
    EXPECT_EQ(style.blossom.shape, "cherry-blossom");
    EXPECT_EQ(style.leaf.shape, "");
    EXPECT_EQ(style.palette.wood, (Colour{0x5a, 0x43, 0x3c}));
    EXPECT_TRUE(style.page.background);
}

TEST(StyleXml, GroupsOf3DModelsAreWrittenWholeOrNotAtAll) {
    Style style = read("<tree name='x'/>");
    EXPECT_EQ(to_xml(style).find("<prism"), std::string::npos);
    EXPECT_NE(to_xml(style).find("<look wood="), std::string::npos);
    style.prism.depth = 9;
    EXPECT_NE(to_xml(style).find("<prism length=\"60\" depth=\"9\" length-power=\"1\""),
              std::string::npos);
    EXPECT_EQ(to_xml(style).find("<foliage"), std::string::npos);
    EXPECT_EQ(read(to_xml(style)).prism.depth, 9);
}

TEST(StyleXml, WhatIsNotSaidIsAsInTheBase) {
    const Style style = read_file_style("weeping.xml");
    EXPECT_EQ(style.name, "weeping");
    EXPECT_EQ(style.title, "Weeping cherry");
    EXPECT_EQ(style.description, "");
    EXPECT_EQ(style.energy.growth.type, TreeType::b);
    EXPECT_EQ(style.energy.growth.energy, 250);
    EXPECT_EQ(style.energy.space.habit_rad, (std::vector{0.0, radians(150)}));
}

TEST(StyleXml, NamedPalettesChangeTheMainOneOfTheWholeStyle) {
    const Style base = read_file_style("cherry.xml");
    ASSERT_EQ(base.palettes.size(), 1U);
    EXPECT_EQ(base.palettes[0].name, "dark");
    EXPECT_EQ(base.palettes[0].palette.paper, (Colour{0x1c, 0x22, 0x30}));
    EXPECT_EQ(base.palettes[0].palette.wood, base.palette.wood);

    const Style style = read_file_style("weeping.xml");
    ASSERT_EQ(style.palettes.size(), 2U);
    EXPECT_EQ(style.palettes[0].palette.paper, (Colour{0x1c, 0x22, 0x30}));
    EXPECT_EQ(style.palettes[0].palette.wood, (Colour{0x33, 0x33, 0x33}));
    EXPECT_EQ(style.palettes[0].palette.mark, (Colour{0, 0, 0}));
    EXPECT_EQ(style.palettes[1].name, "ink");
    EXPECT_EQ(style.palettes[1].palette.mark, style.palette.mark);
}

TEST(StyleXml, APaletteIsChosenByName) {
    Style style = read_file_style("cherry.xml");
    choose_palette(style, "dark");
    EXPECT_EQ(style.palette.paper, (Colour{0x1c, 0x22, 0x30}));
    const auto message = [&](const char* name) {
        try {
            choose_palette(style, name);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("chosen");
    };
    EXPECT_EQ(message("drak"), "'cherry' has no palette 'drak' (did you mean 'dark'?)");
    EXPECT_EQ(message("winter"), "'cherry' has no palette 'winter' (it has dark)");
    style.palettes.clear();
    EXPECT_EQ(message("dark"), "'cherry' has no palette 'dark' (it has none but its own)");
}

TEST(StyleXml, AssignmentsAreTakenAllOrNone) {
    Style style;
    const std::vector<std::string> good = {"growth.energy=800", "look.wood=line"};
    set_parameters(style, good, "--set");
    EXPECT_EQ(style.energy.growth.energy, 800);
    EXPECT_EQ(style.look.wood, Look::line);
    const std::vector<std::string> bad = {"growth.energy=900", "growth.enery=1", "look.wood=x",
                                          "oops"};
    try {
        set_parameters(style, bad, "--set");
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "--set: growth.enery: no such parameter (did you mean 'growth.energy'?)\n"
                     "--set: look.wood: 'x' is not known (expected solid, silhouette, outline or "
                     "line)\n"
                     "--set: 'oops' is not an assignment (expected group.name=value)");
    }
    EXPECT_EQ(style.energy.growth.energy, 800);
}

TEST(StyleXml, LongFilesOfMistakesAreCutShort) {
    std::string xml = "<tree name='x'>";
    for (int i = 0; i < 2000; ++i)
        xml += "<y/>\n";
    const std::string message = errors(xml + "</tree>");
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 100);
    EXPECT_TRUE(message.ends_with("and more from here on")) << message;
}

TEST(StyleXml, PlacesCountCodePointsAndKnowEveryLineEnding) {
    EXPECT_EQ(errors("<tree name='x' title='葉葉' z='1'/>"),
              "test.xml:1:27: tree.z: no such "
              "attribute");
    EXPECT_EQ(errors("\xEF\xBB\xBF<tree name='x'>\r\n<q/>\r<r/></tree>"),
              "test.xml:2:2: q: no such group\ntest.xml:3:2: r: no such group");
}

// Any text for any parameter, as a user could have written it.
rc::Gen<std::string> value_for(const Parameter& parameter) {
    const Limits limits = parameter.limits;
    const auto number = rc::gen::map(rc::gen::inRange(0, 10001), [limits](int part) {
        return limits.least + (limits.most - limits.least) * part / 10000;
    });
    switch (parameter.field.index()) {
        case 0:
            return rc::gen::map(number, shortest_text);
        case 1:
            return rc::gen::map(number, [](double v) { return shortest_text(std::floor(v)); });
        case 2:
            return rc::gen::element<std::string>("yes", "no");
        case 3:
            return rc::gen::elementOf(std::get<Choice>(parameter.field).names);
        case 4:
            return rc::gen::map(rc::gen::pair(number, number), [](std::pair<double, double> ends) {
                return shortest_text(std::min(ends.first, ends.second)) + ' ' +
                       shortest_text(std::max(ends.first, ends.second));
            });
        case 5:
            return rc::gen::map(rc::gen::nonEmpty(rc::gen::container<std::vector<double>>(number)),
                                [](std::vector<double> values) {
                                    values.resize(std::min<std::size_t>(values.size(), 32));
                                    std::string text;
                                    for (const double value : values)
                                        text += shortest_text(value) + ' ';
                                    return text;
                                });
        case 6:
            return rc::gen::map(rc::gen::container<std::string>(
                                    6, rc::gen::elementOf(std::string("0123456789abcdef"))),
                                [](const std::string& digits) { return '#' + digits; });
        default:
            return rc::gen::element<std::string>("", "oak", "maple");
    }
}

Style any_style() {
    Style style;
    style.name = "any";
    style.title = *rc::gen::element<std::string>("Any", "<&\"'>", "枝葉", " a\n\tb ");
    for (const Parameter& parameter : parameters()) {
        const auto wrong = assign(style, parameter, *value_for(parameter));
        RC_ASSERT(!wrong);
    }
    NamedPalette named{"other", style.palette};
    named.palette.leaf = {1, 2, 3};
    style.palettes.push_back(named);
    return style;
}

RC_GTEST_PROP(StyleXml, WhatIsWrittenIsReadAgain, ()) {
    const Style style = any_style();
    const std::string xml = to_xml(style);
    const Style again = read(xml);
    RC_ASSERT(again.title == style.title);
    RC_ASSERT(again.energy.branch.turn_rad == style.energy.branch.turn_rad);
    RC_ASSERT(again.energy.space.habit_rad == style.energy.space.habit_rad);
    RC_ASSERT(again.energy.growth.length_mm == style.energy.growth.length_mm);
    RC_ASSERT(again.palettes.at(0).palette.leaf == style.palettes.at(0).palette.leaf);
    RC_ASSERT(to_xml(again) == xml);
}

TEST(StyleXml, ADefaultStyleIsAlreadyCanonicalOnceRead) {
    const Style style = read("<tree name='x'/>");
    const Style again = read(to_xml(style));
    EXPECT_EQ(again.leaf.fan_rad, style.leaf.fan_rad);
    EXPECT_EQ(again.leaf.along_angle_rad, style.leaf.along_angle_rad);
    EXPECT_NEAR(style.leaf.fan_rad, Style().leaf.fan_rad, 1e-15);
}

TEST(StyleXml, ModelsAreInheritedAndWritten) {
    Style style = read("<tree name='x' models=' prop-root\nenergy '/>");
    EXPECT_EQ(style.models, (std::vector<Model>{Model::prop_root, Model::energy}));
    EXPECT_NE(to_xml(style).find(" models=\"prop-root energy\""), std::string::npos);
    EXPECT_EQ(read(to_xml(style)).models, style.models);
    style.models = {Model::energy};
    EXPECT_EQ(to_xml(style).find("models"), std::string::npos) << "files of old stay as they are";
}

}  // namespace
}  // namespace edaha
