// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "read_leaf_file.h"

namespace edaha {
namespace {

// leaves/: what programs write. The two of Inkscape were made by it (1.2.2); the others follow the
// manner of Illustrator CS6, Illustrator 2023 and Figma.
LeafImport read(const std::string& name) {
    LeafImport import = read_leaf(text_of_file(TESTS_DIR "/unit/ornament/leaves/" + name), name);
    EXPECT_EQ(breaches(import.leaf), "") << name;
    EXPECT_GT(import.leaf.box.width(), 1) << name;
    EXPECT_NEAR(import.leaf.box.height(), 10, .2) << name;  // and half a stroke
    return import;
}

TEST(LeafExports, InkscapesTwoFormatsAreTheSameLeaf) {
    const LeafImport own = read("inkscape.svg");
    const LeafImport plain = read("inkscape-plain.svg");
    EXPECT_EQ(lines(own.warnings), "");
    EXPECT_EQ(lines(plain.warnings), "");
    EXPECT_EQ(inks(own.leaf), "leaf/none, none/#2f5d34, none/#2f5d34, none/#2f5d34, #ffffff/none");
    EXPECT_EQ(inks(own.leaf), inks(plain.leaf));
    EXPECT_FLOAT_EQ(own.leaf.shapes[2].paint.stroke_opacity, .6F);
    for (std::size_t i = 0; i < own.leaf.shapes.size(); ++i) {
        // The ellipse is an <ellipse> in one and four arcs in the other.
        const Bounds a = bounds(own.leaf.shapes[i].path), b = bounds(plain.leaf.shapes[i].path);
        EXPECT_NEAR(a.min.x, b.min.x, 1e-6);
        EXPECT_NEAR(a.max.y, b.max.y, 1e-6);
    }
}

TEST(LeafExports, IllustratorsOldFormat) {
    const LeafImport import = read("illustrator-cs6.svg");
    EXPECT_EQ(inks(import.leaf), "#8cc63f/none, #006837/none, #ffffff/none");
    EXPECT_FLOAT_EQ(import.leaf.shapes[2].paint.fill_opacity, .4F);
    EXPECT_EQ(
        lines(import.warnings),
        "illustrator-cs6.svg:23:36: fill: linearGradient 'SVGID_1_' is not kept, a flat colour "
        "is\n");
}

TEST(LeafExports, IllustratorsNewFormat) {
    const LeafImport import = read("illustrator-2023.svg");
    EXPECT_EQ(inks(import.leaf),
              "#8cc63f/none, leaf/none, #d9e021/none, none/#006837, none/#006837");
    EXPECT_FLOAT_EQ(import.leaf.shapes[2].paint.fill_opacity, .5F);
    EXPECT_EQ(
        lines(import.warnings),
        "illustrator-2023.svg:1:200: fill: linearGradient 'linear-gradient' is not kept, a flat "
        "colour is\n"
        "illustrator-2023.svg:1:438: mix-blend-mode: 'multiply' is not kept\n");
}

TEST(LeafExports, Figma) {
    const LeafImport import = read("figma.svg");
    EXPECT_EQ(inks(import.leaf), "leaf/none, none/#2f5d34, none/leaf");
    EXPECT_EQ(
        lines(import.warnings),
        "figma.svg:2:25: clip-path: 'url(#clip0_12_34)' is not kept\n"
        "figma.svg:4:55: stroke: linearGradient 'paint0_linear_12_34' is not kept, a flat colour "
        "is\n");
}

}  // namespace
}  // namespace edaha
