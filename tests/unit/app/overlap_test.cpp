// SPDX-License-Identifier: MIT
#include "app/overlap.h"

#include <gtest/gtest.h>

#include "app/pipeline.h"
#include "geometry/measure.h"
#include "geometry/unite.h"
#include "style/catalogue.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

// What overlap.h promises.
constexpr double kError = 0.005;

Path square(double x, double y, double side) {
    Path path;
    path.move_to({x, y});
    path.line_to({x + side, y});
    path.line_to({x + side, y + side});
    path.line_to({x, y + side});
    path.close();
    return path;
}

Drawing with_layer(const std::string& label, std::vector<Element> elements) {
    Drawing drawing;
    drawing.layers.push_back({label, {}, std::move(elements)});
    return drawing;
}

// The same by planar maps: the areas themselves, to 0.001 of them, but for a thousand times as
// long.
class Areas {
  public:
    explicit Areas(const Drawing& drawing) {
        for (const Symbol& symbol : drawing.symbols) {
            std::vector<Path> paths;
            for (const Shape& shape : symbol.shapes)
                paths.push_back(shape.path);
            leaves_.push_back(unite(paths, {.tolerance = kTolerance}));
        }
        for (const Layer& layer : drawing.layers) {
            if (layer.label != "Ground") add(layer.children);
        }
    }

    double overlap_ratio() const { return 1 - area_of_union(shapes_, kTolerance) / sum_; }

  private:
    static constexpr double kTolerance = 0.01;

    void add(const std::vector<Element>& elements) {
        for (const Element& element : elements) {
            if (const auto* group = std::get_if<Group>(&element)) add(group->children);
            if (const auto* shape = std::get_if<Shape>(&element)) {
                if (!shape->id.ends_with(".shade") && !shape->id.ends_with(".marks"))
                    add(shape->path);
            }
            if (const auto* use = std::get_if<Use>(&element))
                add(transformed(use->page_from_symbol, leaves_[use->symbol]));
        }
    }

    void add(const Path& path) {
        sum_ += area_of_union(std::span(&path, 1), kTolerance);
        shapes_.push_back(path);
    }

    std::vector<Path> leaves_, shapes_;
    double sum_ = 0;
};

TEST(Overlap, NothingHidesNothing) {
    EXPECT_EQ(overlap_ratio({}), 0);
    EXPECT_EQ(overlap_ratio(with_layer("Wood", {Shape{"a", square(0, 0, 10), {}}})), 0);
}

TEST(Overlap, IsTheHiddenPartOfAllAreas) {
    const Shape left{"a", square(0, 0, 10), {}};
    const Shape right{"b", square(5, 0, 10), {}};
    const Shape apart{"c", square(100, 0, 10), {}};
    // Two squares share half of one: 15 of 20 are seen.
    EXPECT_NEAR(overlap_ratio(with_layer("Wood", {left, right})), 0.25, kError);
    EXPECT_NEAR(overlap_ratio(with_layer("Wood", {left, right, apart})), 1.0 / 6, kError);
    EXPECT_NEAR(overlap_ratio(with_layer("Wood", {Group{"g", {}, {left, left}}})), 0.5, kError);
}

TEST(Overlap, LeavesCountAsWholeOutlines) {
    // A leaf of 2 x 2 with a detail on its blade, drawn three times as large: 36.
    Drawing drawing = with_layer(
        "Leaves", {Use{0, Affine{3, 0, 0, 3, 0, 0}, {}}, Use{0, Affine{3, 0, 0, 3, 3, 0}, {}}});
    drawing.symbols.push_back(
        {"leaf", {Shape{"", square(0, 0, 2), {}}, Shape{"", square(0.5, 0.5, 1), {}}}});
    EXPECT_NEAR(overlap_ratio(drawing), 0.25, kError);
}

TEST(Overlap, GroundAndBarkDoNotCount) {
    const Shape limb{"limb-1", square(0, 0, 10), {}};
    const Shape shade{"limb-1.shade", square(0, 0, 5), {}};
    const Shape marks{"limb-1.marks", square(0, 0, 5), {}};
    EXPECT_EQ(overlap_ratio(with_layer("Wood", {limb, shade, marks})), 0);
    EXPECT_EQ(overlap_ratio(with_layer("Ground", {limb, limb})), 0);
    EXPECT_EQ(overlap_ratio(with_layer("Background", {limb, limb})), 0);
}

class OverlapOfStyle : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Kinds, OverlapOfStyle,
                         testing::Values("cherry", "oak", "willow", "winter",
                                         "paper/energy-a-100-plain", "paper/energy-b-100-drop"));

TEST_P(OverlapOfStyle, IsThatOfTheExactAreas) {
    const Catalogue catalogue;
    Style style = read_style(catalogue.find_style(GetParam()), catalogue);
    style.energy.growth.energy = 100;
    const DrawingLoader load{
        [&](const std::string& name) { return read_leaf(catalogue.find_leaf(name).text, name); },
        {}};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        style.energy.variant.seed = seed;
        const Drawing drawing = draw_picture(style, load).drawing;
        EXPECT_NEAR(overlap_ratio(drawing), Areas(drawing).overlap_ratio(), kError) << seed;
    }
}

}  // namespace
}  // namespace edaha
