// SPDX-License-Identifier: MIT
#include "app/pipeline.h"

#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "app/overlap.h"
#include "drawing/check.h"
#include "style/catalogue.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

LeafImport load_leaf(const std::string& name) {
    const Catalogue catalogue;
    return read_leaf(catalogue.find_leaf(name).text, name);
}

const DrawingLoader load{load_leaf, {}};

Style style_of(const std::string& name, std::uint64_t seed = 1) {
    const Catalogue catalogue;
    Style style = read_style(catalogue.find_style(name), catalogue);
    style.energy.variant.seed = seed;
    return style;
}

// Every limb's path in the layers of wood, by id.
std::map<std::string, Path> limbs_of(const Drawing& drawing) {
    std::map<std::string, Path> limbs;
    const auto visit = [&](const auto& self, const std::vector<Element>& elements) -> void {
        for (const Element& element : elements) {
            if (const auto* group = std::get_if<Group>(&element)) self(self, group->children);
            if (const auto* shape = std::get_if<Shape>(&element)) limbs[shape->id] = shape->path;
        }
    };
    for (const Layer& layer : drawing.layers) {
        if (layer.label.starts_with("Wood")) visit(visit, layer.children);
    }
    return limbs;
}

double mean_overlap(const std::string& name) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        sum += overlap_ratio(draw_picture(style_of(name, seed), load).drawing);
    }
    return sum / 30;
}

}  // namespace

// Mama & Nakajima 3.2, by our measure: flatter from plain to competition to dropping.
class Overlap : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Types, Overlap, testing::Values("a", "b"));

TEST_P(Overlap, FallsFromPlainToCompetitionToDropping) {
    const std::string stem = std::string("paper/energy-") + GetParam() + "-500-";
    const double plain = mean_overlap(stem + "plain");
    const double space = mean_overlap(stem + "space");
    const double drop = mean_overlap(stem + "drop");
    RecordProperty("plain", std::to_string(plain));
    RecordProperty("space", std::to_string(space));
    RecordProperty("drop", std::to_string(drop));
    EXPECT_LT(space, plain);
    EXPECT_LT(drop, space);
}

// What leaves, blossom, fruit, palette and the marks on bark are may not move a branch. The page
// is as large as the picture, so positions are compared relative to the trunk's foot.
TEST(Pipeline, NoLeafOrColourMovesABranch) {
    Style style = style_of("apple", 4);
    style.page.margin_mm = 30;
    const auto relative = [](const Drawing& drawing) {
        std::map<std::string, Path> limbs = limbs_of(drawing);
        const Vec2 origin = limbs.at("trunk").points.front();
        for (auto& [id, path] : limbs) {
            for (Vec2& point : path.points)
                point -= origin;
        }
        return limbs;
    };
    const auto before = relative(draw_picture(style, load).drawing);
    style.leaf.shape = "oak";
    style.leaf.size_mm *= 1.7;
    style.leaf.count = 1;
    style.leaf.along_mm = 9;
    style.fruit.share = 0.5;
    style.blossom.shape = "cherry-blossom";
    style.palette.wood = {1, 2, 3};
    style.palette.leaf = {200, 0, 0};
    const auto after = relative(draw_picture(style, load).drawing);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [id, path] : before) {
        const Path& other = after.at(id);
        ASSERT_EQ(path.verbs, other.verbs) << id;
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            EXPECT_NEAR(path.points[i].x, other.points[i].x, 1e-9) << id;
            EXPECT_NEAR(path.points[i].y, other.points[i].y, 1e-9) << id;
        }
    }
}

TEST(Pipeline, LooksMoveNoBranch) {
    Style style = style_of("oak", 2);
    const TreeCounts before = draw_picture(style, load).counts;
    style.look.gnarl = 2;
    style.look.wood = Look::silhouette;
    const TreeCounts after = draw_picture(style, load).counts;
    EXPECT_EQ(before.branches, after.branches);
    EXPECT_EQ(before.limbs, after.limbs);
}

TEST(Pipeline, EveryLookKeepsTheContract) {
    for (const Look look : {Look::solid, Look::silhouette, Look::outline, Look::line}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Style style = style_of("oak", seed);
            style.look.wood = look;
            const auto problems = check(draw_picture(style, load).drawing);
            EXPECT_TRUE(problems.empty()) << problems.front();
        }
    }
}

TEST(Pipeline, ASilhouetteIsOnePathWithoutOverlaps) {
    Style style = style_of("winter", 3);
    style.leaf.shape.clear();
    style.look.back = 0;
    const double overlapping = overlap_ratio(draw_picture(style, load).drawing);
    EXPECT_GT(overlapping, 0.05);
    style.look.wood = Look::silhouette;
    const Drawing drawing = draw_picture(style, load).drawing;
    EXPECT_EQ(limbs_of(drawing).size(), 1U);
    EXPECT_NEAR(overlap_ratio(drawing), 0, 1e-3);
}

TEST(Pipeline, SwatchesAreThePalettesColours) {
    const Style style = style_of("oak");
    const Drawing drawing = draw_picture(style, load).drawing;
    const auto leaf =
        std::find_if(drawing.swatches.begin(), drawing.swatches.end(),
                     [](const Swatch& swatch) { return swatch.name == "leaf-shade"; });
    ASSERT_NE(leaf, drawing.swatches.end());
    EXPECT_EQ(leaf->colour, style.palette.leaf_shade);
}

// For print in few inks: nothing is drawn in a colour that the palette has not.
TEST(Pipeline, StrictPalettesRecolourTheLeaves) {
    Style style = style_of("cherry");
    choose_palette(style, "print");
    ASSERT_TRUE(style.palette.strict);
    const Drawing drawing = draw_picture(style, load).drawing;
    for (const Symbol& symbol : drawing.symbols) {
        for (const Shape& shape : symbol.shapes) {
            if (shape.paint.fill.kind != Ink::Kind::colour) continue;
            const auto known = [&](const Swatch& swatch) {
                return swatch.colour == shape.paint.fill.colour;
            };
            EXPECT_TRUE(std::any_of(drawing.swatches.begin(), drawing.swatches.end(), known))
                << shape.id;
        }
    }
}

TEST(Pipeline, PageSizeIsWhatIsAskedFor) {
    Style style = style_of("birch", 2);
    style.page.size_mm = 120;
    const Drawing drawing = draw_picture(style, load).drawing;
    EXPECT_NEAR(std::max(drawing.width_mm, drawing.height_mm), 120, 0.02);
}

TEST(Pipeline, LayersStandInTheOrderThatTheyArePainted) {
    const Drawing drawing = draw_picture(style_of("apple", 1), load).drawing;
    std::vector<std::string> labels;
    for (const Layer& layer : drawing.layers)
        labels.push_back(layer.label);
    const std::vector<std::string> all{"Ground", "Wood behind", "Leaves behind", "Fruit behind",
                                       "Wood",   "Leaves",      "Fruit"};
    std::size_t at = 0;
    for (const std::string& label : labels) {
        while (at < all.size() && all[at] != label)
            ++at;
        EXPECT_LT(at, all.size()) << label;
    }
}

}  // namespace edaha
