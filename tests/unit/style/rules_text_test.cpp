// SPDX-License-Identifier: MIT
#include "style/rules_text.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

std::string first_error(const std::string& xml) {
    try {
        read_style({xml, "test.xml", {}}, Catalogue());
    } catch (const InputError& error) {
        return error.what();
    }
    return "read";
}

// The same broken rules, however they are written: the place is that of the file.
constexpr const char* kBroken = "axiom: A(1";

std::string place_in(const std::string& before, const std::string& rules) {
    const std::string error =
        first_error("<tree name='x'>" + before + "<rules>" + rules + "</rules></tree>");
    return error.substr(0, error.find(" "));
}

TEST(RulesText, PlacesAreThoseOfTheFile) {
    RulesText text;
    const std::string file = "..é&gt;\r\n<![CDATA[a<]]>";
    text.add(file, 2, "é>\n", false);
    text.add(file, file.find("a<"), "a<", true);
    EXPECT_EQ(text.text(), "é>\na<");
}

TEST(RulesText, AnEmptyTextHasNoProblem) {
    EXPECT_EQ(first_error("<tree name='x'><rules> \n </rules></tree>"), "read");
    EXPECT_EQ(first_error("<tree name='x'><rules/></tree>"), "read");
}

TEST(RulesText, LinesAndColumnsCountFromTheFileOn) {
    const std::string on_top = place_in("", kBroken);
    EXPECT_NE(on_top.find("test.xml:1:"), std::string::npos) << on_top;
    const std::string below = place_in("\n\n", kBroken);
    EXPECT_NE(below.find("test.xml:3:"), std::string::npos) << below;
}

TEST(RulesText, ReferencesAndCdataGiveOneText) {
    const Style escaped =
        read_style({"<tree name='x'><rules>axiom: A(1)\nA(t) : t &gt; 5 -> A(1)\n</rules></tree>",
                    "a.xml",
                    {}},
                   Catalogue());
    const Style raw = read_style(
        {"<tree name='x'><rules><![CDATA[axiom: A(1)\nA(t) : t > 5]]> -> A(1)</rules></tree>",
         "b.xml",
         {}},
        Catalogue());
    EXPECT_EQ(escaped.surface.rules, raw.surface.rules);
    EXPECT_EQ(read_style({to_xml(raw), "c.xml", {}}, Catalogue()).surface.rules, raw.surface.rules);
}

}  // namespace
}  // namespace edaha
