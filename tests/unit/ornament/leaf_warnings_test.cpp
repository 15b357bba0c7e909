// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "ornament/leaf.h"
#include "read_leaf_file.h"

namespace edaha {
namespace {

// The warnings of a drawing with a blade and, on line 2, `inside`.
std::string warnings(const std::string& inside) {
    std::string text = "<svg><path id='blade' d='M3 8C0 5 0 2 3 0C6 2 6 5 3 8Z'/>\n";
    text += inside;
    text += "</svg>";
    const LeafImport import = read_leaf(text, "l");
    EXPECT_EQ(breaches(import.leaf), "");
    return lines(import.warnings);
}

TEST(LeafWarnings, ElementsThatAreNotKeptAreNamed) {
    EXPECT_EQ(warnings("<text x='1'>a</text>"), "l:2:2: text is not kept\n");
    EXPECT_EQ(warnings("<g><image/></g>"), "l:2:5: image is not kept\n");
    EXPECT_EQ(warnings("<foreignObject/><script/>"),
              "l:2:2: foreignObject is not kept\nl:2:18: script is not kept\n");
    EXPECT_EQ(warnings("<path d='M0 0H1V1Z'><animate/></path>"), "l:2:22: animate is not kept\n");
    EXPECT_EQ(warnings("<cirle r='3'/>"),
              "l:2:2: 'cirle' is not an element of SVG, and left out (did you mean 'circle'?)\n");
}

TEST(LeafWarnings, PropertiesThatAreNotKeptAreNamed) {
    const auto path = [](const std::string& attribute) {
        return warnings("<path " + attribute + " d='M0 0H1V1Z'/>");
    };
    EXPECT_EQ(path("clip-path='url(#c)'"), "l:2:18: clip-path: 'url(#c)' is not kept\n");
    EXPECT_EQ(path("mask='url(#m)'"), "l:2:13: mask: 'url(#m)' is not kept\n");
    EXPECT_EQ(path("style='filter:url(#f)'"), "l:2:21: filter: 'url(#f)' is not kept\n");
    EXPECT_EQ(path("marker-end='url(#a)'"), "l:2:19: marker-end: 'url(#a)' is not kept\n");
    EXPECT_EQ(path("stroke-dasharray='1 2'"), "l:2:25: stroke-dasharray: '1 2' is not kept\n");
    EXPECT_EQ(path("stroke-linecap='square'"), "l:2:23: stroke-linecap: 'square' is not kept\n");
    EXPECT_EQ(path("style='mix-blend-mode:multiply'"),
              "l:2:29: mix-blend-mode: 'multiply' is not kept\n");
    EXPECT_EQ(path("style='stroke-dasharray:none;filter:none;mask:none'"), "");
    EXPECT_EQ(path("fil='red'"),
              "l:2:7: path: attribute 'fil' is unknown, and left out (did you mean 'fill'?)\n");
    EXPECT_EQ(path("style='stroke-widht:2'"),
              "l:2:27: property 'stroke-widht' is unknown, and left "
              "out (did you mean 'stroke-width'?)\n");
    EXPECT_EQ(path("fill='var(--green)'"), "l:2:13: fill: 'var(--green)' is not kept\n");
    EXPECT_EQ(path("style='fill'"),
              "l:2:14: style: 'fill' is not a declaration (expected property: value)\n");
}

TEST(LeafWarnings, GradientsAndPatternsAreNamed) {
    const std::string gradient =
        "<linearGradient id='a'><stop stop-color='#112233'/>"
        "<stop stop-color='#445566'/></linearGradient>\n";
    EXPECT_EQ(warnings(gradient + "<path class='x' fill='url(#a)' d='M0 0H1V1Z'/>"),
              "l:3:23: fill: linearGradient 'a' is not kept, a flat colour is\n");
    EXPECT_EQ(warnings("<pattern id='a'/><path class='x' stroke='url(#a)' d='M0 0H1V1Z'/>"),
              "l:2:42: stroke: pattern 'a' is not kept\n");
    EXPECT_EQ(warnings("<path fill='url(#a) red' d='M0 0H1V1Z'/>"),
              "l:2:13: fill: paint 'a' is not kept, a flat colour is\n");
}

TEST(LeafWarnings, WhatLooksDifferentAfterwardsIsNamed) {
    EXPECT_EQ(warnings("<path fill-rule='evenodd' d='M0 4H8V6H0ZM3 0H5V8H3Z'/>"),
              "l:2:18: fill-rule: 'evenodd' is not kept where rings cross\n");
    EXPECT_EQ(warnings("<path d='M0 0H4V4H0ZM2 2V7H7V2Z'/>"),
              "l:2:2: the fill is not kept where a hole sticks out of its outline\n");
    EXPECT_EQ(warnings("<g opacity='.5'><path d='M0 0H1V1Z'/><path d='M0 0H1V1Z'/></g>"),
              "l:2:2: g: the group's opacity is given to each of its shapes\n");
    EXPECT_EQ(warnings("<path stroke='#000' d='M1 1h0'/>"),
              "l:2:2: a stroke without length is not kept\n");
    EXPECT_EQ(warnings("<use href='veins.svg#a'/>"),
              "l:2:12: use: 'veins.svg#a' is outside this file, and not kept\n");
    EXPECT_EQ(warnings("<style>g path{fill:red}</style>"),
              "l:2:8: style sheet: 'g path' is a selector beyond element, .class and #id, and left "
              "out\n");
}

TEST(LeafWarnings, ANearlyNamedStemIsPointedOut) {
    EXPECT_EQ(warnings("<circle id='Stem' r='1'/>"),
              "l:2:9: id: 'Stem' is not the stem (did you mean 'stem'?)\n");
    EXPECT_EQ(warnings("<circle id='c1' inkscape:label='stem' r='1'/>"),
              "l:2:17: the label is 'stem', but the id counts (expected id=\"stem\")\n");
    EXPECT_EQ(warnings("<defs><circle id='stem' r='1'/></defs>"),
              "l:2:15: id: 'stem' is not drawn where it stands, and does not count\n");
}

TEST(LeafWarnings, OtherVocabulariesAreQuiet) {
    EXPECT_EQ(warnings("<sodipodi:namedview><inkscape:grid/></sodipodi:namedview>"
                       "<g inkscape:label='x' i:knockout='Off' data-name='y' sketch:type='z'/>"
                       "<metadata><rdf:RDF/></metadata><title>t</title><desc/>"),
              "");
}

TEST(LeafWarnings, TheSameThingIsSaidOnceAndNotWithoutEnd) {
    EXPECT_EQ(warnings("<g id='a'><image/></g><use href='#a'/><use href='#a'/>"),
              "l:2:12: image is not kept\n");
    std::string images;
    for (int i = 0; i < 150; ++i)
        images += "<image/>";
    const std::string all = warnings(images);
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 101);
    EXPECT_TRUE(all.ends_with("l: there are more (100 are listed)\n"));
}

}  // namespace
}  // namespace edaha
