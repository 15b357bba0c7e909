// SPDX-License-Identifier: MIT
#include "app/overlap.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

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

TEST(Overlap, NothingHidesNothing) {
    EXPECT_EQ(overlap_ratio({}), 0);
    EXPECT_EQ(overlap_ratio(with_layer("Wood", {Shape{"a", square(0, 0, 10), {}}})), 0);
}

TEST(Overlap, IsTheHiddenPartOfAllAreas) {
    const Shape left{"a", square(0, 0, 10), {}};
    const Shape right{"b", square(5, 0, 10), {}};
    const Shape apart{"c", square(100, 0, 10), {}};
    // Two squares share half of one: 15 of 20 are seen.
    EXPECT_NEAR(overlap_ratio(with_layer("Wood", {left, right})), 0.25, 1e-6);
    EXPECT_NEAR(overlap_ratio(with_layer("Wood", {left, right, apart})), 1.0 / 6, 1e-6);
    EXPECT_NEAR(overlap_ratio(with_layer("Wood", {Group{"g", {}, {left, left}}})), 0.5, 1e-6);
}

TEST(Overlap, LeavesCountAsWholeOutlines) {
    // A leaf of 2 x 2 with a detail on its blade, drawn three times as large: 36.
    Drawing drawing = with_layer(
        "Leaves", {Use{0, Affine{3, 0, 0, 3, 0, 0}, {}}, Use{0, Affine{3, 0, 0, 3, 3, 0}, {}}});
    drawing.symbols.push_back(
        {"leaf", {Shape{"", square(0, 0, 2), {}}, Shape{"", square(0.5, 0.5, 1), {}}}});
    EXPECT_NEAR(overlap_ratio(drawing), 0.25, 1e-3);
}

TEST(Overlap, GroundAndBarkDoNotCount) {
    const Shape limb{"limb-1", square(0, 0, 10), {}};
    const Shape shade{"limb-1.shade", square(0, 0, 5), {}};
    const Shape marks{"limb-1.marks", square(0, 0, 5), {}};
    EXPECT_EQ(overlap_ratio(with_layer("Wood", {limb, shade, marks})), 0);
    EXPECT_EQ(overlap_ratio(with_layer("Ground", {limb, limb})), 0);
    EXPECT_EQ(overlap_ratio(with_layer("Background", {limb, limb})), 0);
}

}  // namespace
}  // namespace edaha
