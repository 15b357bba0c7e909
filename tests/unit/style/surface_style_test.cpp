// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/error.h"
#include "style/parameter.h"
#include "style/style_xml.h"
#include "style/value.h"
#include "support/run.h"

namespace edaha {
namespace {

Style read_text(const std::string& xml) {
    return read_style({xml, "test.xml", {}}, Catalogue());
}

TEST(SurfaceStyle, ListsReachTheStage) {
    const Style style = read_text(
        "<tree name='x' models='surface'><surface steps='40' winding='0.2' sprig-energy='12'/>"
        "<burl height='900' azimuth='90' step='7'/><burl strength='2'/>"
        "<obstacle shape='wire' from='-1 2.5 3' to='4 5 6' radius='9'/></tree>");
    EXPECT_EQ(style.surface.steps, 40);
    EXPECT_EQ(style.surface.winding_rad, radians(0.2));
    EXPECT_EQ(style.sprig.energy, 12);
    ASSERT_EQ(style.surface.burls.size(), 2U);
    EXPECT_EQ(style.surface.burls[0].height_mm, 900);
    EXPECT_EQ(style.surface.burls[0].azimuth_rad, radians(90));
    EXPECT_EQ(style.surface.burls[0].from, 7);
    EXPECT_EQ(style.surface.burls[1].height_mm, BurlPlace().height_mm);
    EXPECT_EQ(style.surface.burls[1].strength, 2);
    ASSERT_EQ(style.surface.obstacles.size(), 1U);
    EXPECT_EQ(style.surface.obstacles[0].shape, SolidShape::wire);
    EXPECT_EQ(style.surface.obstacles[0].from, glm::dvec3(-1, 2.5, 3));
    EXPECT_TRUE(style.surface.hollows.empty());
}

TEST(SurfaceStyle, WritesAllOfItself) {
    const Style style = read_text(
        "<tree name='x' models='surface'><surface decay='7.25'/><burl azimuth='33'/>"
        "<hollow shape='ball' from='1 2 3' radius='0.5'/><hollow shape='box'/></tree>");
    const std::string xml = to_xml(style);
    const Style again = read_text(xml);
    EXPECT_EQ(to_xml(again), xml);
    EXPECT_EQ(again.surface.burls.at(0).azimuth_rad, style.surface.burls.at(0).azimuth_rad);
    ASSERT_EQ(again.surface.hollows.size(), 2U);
    EXPECT_EQ(again.surface.hollows[0].shape, SolidShape::ball);
    EXPECT_EQ(again.surface.hollows[1].shape, SolidShape::box);
    EXPECT_EQ(again.models, std::vector{Model::surface});
}

TEST(SurfaceStyle, MeshesAreBesideTheirStyle) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "rock.obj", "");
    test::write_whole(folder / "own.xml",
                      "<tree name='own' models='surface'><obstacle/>"
                      "<obstacle shape='mesh' file='rock.obj' from='1 2 3'/></tree>");
    const Catalogue catalogue;
    const Style style = read_style(catalogue.find_style(folder / "own.xml"), catalogue);
    ASSERT_EQ(style.surface.obstacles.size(), 2U);
    EXPECT_EQ(style.surface.obstacles[1].file, folder / "rock.obj");
    EXPECT_EQ(style.surface.obstacles[1].mesh, nullptr);  // who draws reads it
    const std::string xml = to_xml(style);
    EXPECT_EQ(to_xml(read_text(xml)), xml);
    EXPECT_EQ(xml.find("file=\"\""), std::string::npos);
}

TEST(SurfaceStyle, AListTakesThePlaceOfTheBases) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "base.xml",
                      "<tree name='base' models='surface'><burl height='1'/><burl height='2'/>"
                      "<obstacle radius='5'/></tree>");
    test::write_whole(folder / "own.xml",
                      "<tree name='own' extends='base.xml'><burl height='3'/></tree>");
    const Catalogue catalogue;
    const Style style = read_style(catalogue.find_style(folder / "own.xml"), catalogue);
    ASSERT_EQ(style.surface.burls.size(), 1U);
    EXPECT_EQ(style.surface.burls[0].height_mm, 3);
    ASSERT_EQ(style.surface.obstacles.size(), 1U);
    EXPECT_EQ(style.surface.obstacles[0].radius_mm, 5);
}

TEST(SurfaceStyle, ListsAreNotForSingleAssignments) {
    Style style;
    const std::vector<std::string> one{"burl.radius=3"};
    try {
        set_parameters(style, one, "--set");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "--set: burl.radius: only style files can set it: there may be many");
    }
}

TEST(SurfaceStyle, EveryListHasGoodDefaults) {
    for (const ParameterList& list : parameter_lists()) {
        for (const Parameter& parameter : list.parameters) {
            Style style;
            const std::string text = value_text(style, parameter);
            EXPECT_EQ(assign(style, parameter, text), std::nullopt) << parameter.key();
            EXPECT_EQ(list.size(style), 1U) << parameter.key();
            EXPECT_EQ(value_text(style, parameter), text) << parameter.key();
        }
    }
}

}  // namespace
}  // namespace edaha
