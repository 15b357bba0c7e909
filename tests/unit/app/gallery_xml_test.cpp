// SPDX-License-Identifier: MIT
#include "app/gallery/gallery_xml.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "style/samples.h"
#include "support/run.h"

namespace edaha {
namespace {

Gallery read(const std::string& text, const std::string& folder = "") {
    const Catalogue catalogue;
    LeafShelf leaves(catalogue, folder);
    return read_gallery({text, "g.xml", folder}, catalogue, leaves);
}

Gallery read_page(const std::string& blocks) {
    return read("<gallery title='T'>\n<page name='p' title='P'>\n" + blocks +
                "\n</page></gallery>");
}

std::string problems(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return std::string(error.what()) + '\n';
    }
    return "";
}

std::string problems_of_page(const std::string& blocks) {
    return problems("<gallery title='T'>\n<page name='p' title='P'>\n" + blocks +
                    "\n</page></gallery>");
}

std::vector<std::string> commands(const Plate& plate) {
    std::vector<std::string> commands;
    for (const GalleryTree& tree : plate.trees)
        commands.push_back(tree.tree.command);
    return commands;
}

using Texts = std::vector<std::string>;

TEST(GalleryXml, APictureIsATreeWithItsCommand) {
    const Gallery gallery = read_page(
        "<picture name='a' style='oak' seed='7' vary='0.5' look='line' palette='dark' size='10cm'"
        " background='yes' caption='An *oak*'><set growth.energy='40' branch.turn='3'/>"
        "<set name='space.cell' value='9'/></picture>");
    ASSERT_EQ(gallery.plates.size(), 1U);
    const Plate& plate = gallery.plates[0];
    EXPECT_EQ(plate.stem(), "p/a");
    EXPECT_EQ(plate.alt(), "An oak");
    EXPECT_EQ(commands(plate),
              Texts{"edaha draw oak --seed 7 --vary 0.5 --look line --set growth.energy=40 "
                    "--set branch.turn=3 --set space.cell=9 --palette dark --size 10cm "
                    "--background"});
    const Style& style = plate.trees[0].tree.style;
    EXPECT_EQ(style.energy.variant.seed, 7U);
    EXPECT_TRUE(style.page.background);
    EXPECT_EQ(style.page.size_mm, 100);
}

TEST(GalleryXml, PicturesOfAStripShareWhatTheStripSays) {
    const Gallery gallery = read_page(
        "<strip name='s' style='oak' height='3cm'><set growth.energy='9'/>"
        "<picture seed='1' caption='one'/><picture style='fir'><set growth.energy='8'/></picture>"
        "</strip>");
    const Plate& plate = gallery.plates.at(0);
    EXPECT_EQ(commands(plate), (Texts{"edaha draw oak --seed 1 --set growth.energy=9",
                                      "edaha draw fir --set growth.energy=8"}));
    EXPECT_EQ(plate.trees[0].caption, "one");
    EXPECT_EQ(std::get<StripParams>(plate.arrangement).tallest_mm, 30);
}

TEST(GalleryXml, APosterHasRows) {
    const Gallery gallery = read_page(
        "<poster name='s' style='oak' caption='All'><row><picture seed='1'/><picture "
        "seed='2'/></row>"
        "<row><picture style='fir'/></row></poster>");
    const auto& params = std::get<PosterParams>(gallery.plates.at(0).arrangement);
    EXPECT_EQ(params.rows, (std::vector<std::size_t>{2, 1}));
    EXPECT_EQ(gallery.plates[0].trees.size(), 3U);
}

TEST(GalleryXml, ASweepIsAStripOverItsValues) {
    const Gallery gallery = read_page(
        "<sweep name='s' style='oak' parameter='growth.energy' values='9 | 20|40' seeds='3'/>");
    EXPECT_EQ(commands(gallery.plates.at(0)),
              (Texts{"edaha draw oak --seed 3 --set growth.energy=9",
                     "edaha draw oak --seed 3 --set growth.energy=20",
                     "edaha draw oak --seed 3 --set growth.energy=40"}));
    EXPECT_EQ(gallery.plates[0].trees[1].caption, "20");
}

TEST(GalleryXml, ASweepWithSeedsIsAStripAValue) {
    const Gallery gallery = read_page(
        "<sweep name='s' style='oak' parameter='variant.vary' values='0|1' seeds='3 4'/>");
    ASSERT_EQ(gallery.plates.size(), 2U);
    EXPECT_EQ(gallery.plates[0].stem(), "p/s-1");
    EXPECT_EQ(commands(gallery.plates[1]),
              (Texts{"edaha draw oak --seed 3 --vary 1", "edaha draw oak --seed 4 --vary 1"}));
    EXPECT_EQ(gallery.plates[1].alt(), "variant.vary=1");
}

TEST(GalleryXml, TheManualHasEveryParameterOfItsGroups) {
    const Gallery gallery = read_page(
        "<parameters groups='growth palette' style='winter' height='2cm'>"
        "<for parameter='growth'><set space.cell='9'/></for>"
        "<for parameter='growth.energy' values='5 | 6'><set space.cell='8'/></for></parameters>");
    ASSERT_EQ(gallery.pages[0].blocks.size(), 2U);
    const auto& growth = std::get<ManualGroup>(gallery.pages[0].blocks[0]);
    const auto& palette = std::get<ManualGroup>(gallery.pages[0].blocks[1]);
    EXPECT_EQ(growth.entries.size(), find_group("growth")->parameters.size());
    for (const ManualEntry& entry : palette.entries)
        EXPECT_EQ(entry.plate.has_value(), !samples(*entry.parameter).empty());
    for (const ManualEntry& entry : growth.entries) {
        EXPECT_EQ(entry.circumstances.front(), "space.cell=9");
        EXPECT_EQ(entry.plate.has_value(), !samples(*entry.parameter).empty());
        if (!entry.plate) continue;
        const Plate& plate = gallery.plates[*entry.plate];
        EXPECT_EQ(plate.name, "growth-" + entry.parameter->name);
        if (entry.parameter->name == "energy") {
            EXPECT_EQ(commands(plate),
                      (Texts{"edaha draw winter --set space.cell=8 --set growth.energy=5",
                             "edaha draw winter --set space.cell=8 --set growth.energy=6"}));
        } else {
            EXPECT_EQ(plate.trees.size(), samples(*entry.parameter).size());
        }
    }
}

TEST(GalleryXml, PathsBeginAtTheFile) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "my.svg",
                      "<svg xmlns='http://www.w3.org/2000/svg' width='4' "
                      "height='4'><path d='M0 0h4v4z'/></svg>");
    test::write_whole(folder / "my.xml", "<tree name='mine'><leaf shape='my.svg'/></tree>");
    const Gallery gallery = read(
        "<gallery title='T'><page name='p' title='P'><picture name='a' style='my.xml'/>"
        "<picture name='b' style='oak'><set leaf.shape='my.svg'/></picture></page></gallery>",
        folder.path());
    for (const Plate& plate : gallery.plates)
        EXPECT_EQ(plate.trees[0].tree.style.leaf.shape, "my.svg");
    EXPECT_EQ(commands(gallery.plates[0]), Texts{"edaha draw my.xml"});
}

TEST(GalleryXml, EveryProblemIsSaidAtItsPlace) {
    EXPECT_EQ(problems("<gallery><page/><pge/></gallery>"),
              "g.xml:1:2: gallery: title is missing\n"
              "g.xml:1:11: page: name is missing\n"
              "g.xml:1:11: page: title is missing\n"
              "g.xml:1:18: 'pge' has no place in 'gallery' (did you mean 'page'?)\n");
    EXPECT_EQ(problems_of_page("<picture name='A b' stlye='oak'/>\n"
                               "<picture name='c' style='oka' seed='x'/>\n"
                               "<picture name='c' style='oak' palette='darc' size='1'>"
                               "<set growth.enery='1' growth.energy='y'/></picture>"),
              "g.xml:3:2: picture: style is missing\n"
              "g.xml:3:10: picture.name: 'A b' is not a name (expected small letters, digits and "
              "hyphens)\n"
              "g.xml:3:21: picture.stlye: no such attribute (did you mean 'style'?)\n"
              "g.xml:4:19: there is no style 'oka' (did you mean 'oak'?)\n"
              "g.xml:4:31: seed: 'x' is not a whole number (expected 0 … 9007199254740991)\n"
              "g.xml:5:2: there are two pictures 'p/c'\n"
              "g.xml:5:31: 'oak' has no palette 'darc' (did you mean 'dark'?)\n"
              "g.xml:5:46: size: '1' is not a length (expected a number and mm, cm, in, px or pt)\n"
              "g.xml:5:60: growth.enery: no such parameter (did you mean 'growth.energy'?)\n"
              "g.xml:5:77: growth.energy: 'y' is not a number (expected 1 … 1e6)\n");
    EXPECT_EQ(problems("<gallery title='T'/>"), "g.xml:1:2: gallery: there is no page in it\n");
}

TEST(GalleryXml, StripsPostersAndTextsHaveTheirProblems) {
    EXPECT_EQ(problems_of_page("<strip name='a' style='oak'><set growth.energy='5'/></strip>"),
              "g.xml:3:2: strip: there is no picture in it\n");
    EXPECT_EQ(
        problems_of_page("<sheet name='a' style='oak' columns='9' width='40mm'><picture/></sheet>"),
        "g.xml:3:2: sheet: there is no room for so many pictures\n");
    EXPECT_EQ(problems_of_page("<poster name='a' style='oak' width='3cm'><row/></poster>"),
              "g.xml:3:30: width: a poster has 200 mm at least\n"
              "g.xml:3:43: row: there is no picture in it\n");
    EXPECT_EQ(problems_of_page("<poster name='a' style='oak'/>"),
              "g.xml:3:2: poster: there is no row in it\n");
    EXPECT_EQ(problems_of_page("<sweep name='a' style='oak' parameter='growth.enery' values='1'/>"),
              "g.xml:3:29: growth.enery: no such parameter (did you mean 'growth.energy'?)\n");
    EXPECT_EQ(problems_of_page("<parameters groups='groth' style='oak'/>"),
              "g.xml:3:13: groups: there is no group 'groth' (did you mean 'growth'?)\n");
    EXPECT_EQ(problems_of_page("<text>[a](javascript:b)</text>"),
              "g.xml:3:2: no page links to 'javascript:b' (expected http, https, mailto or a "
              "path)\n");
    EXPECT_EQ(problems_of_page("<picture name='a' style='oak'>text</picture>"),
              "g.xml:3:2: picture: text 'text' has no place in it\n");
}

TEST(GalleryXml, ABrokenStyleIsToldOnceByItsOwnPlaces) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "bad.xml", "<tree name='bad'><growth energy='x'/></tree>");
    const std::string style = folder / "bad.xml";
    EXPECT_EQ(problems_of_page("<picture name='a' style='" + style +
                               "'/>\n<picture name='b' style='" + style + "'/>"),
              style + ":1:26: growth.energy: 'x' is not a number (expected 1 … 1e6)\n");
}

}  // namespace
}  // namespace edaha
