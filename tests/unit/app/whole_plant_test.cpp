// SPDX-License-Identifier: MIT
// Mangroves: prop roots flattened from a mesh below, a crown grown by energy above.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "app/flat_model.h"
#include "app/pipeline.h"
#include "drawing/check.h"
#include "style/catalogue.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

LeafImport load_leaf(const std::string& name) {
    return read_leaf(Catalogue().find_leaf(name).text, name);
}

const DrawingLoader load{load_leaf, {}};

Style mangrove() {
    const Catalogue catalogue;
    return read_style(catalogue.find_style("young-mangrove"), catalogue);
}

std::vector<std::string> labels_of(const Drawing& drawing) {
    std::vector<std::string> labels;
    for (const Layer& layer : drawing.layers)
        labels.push_back(layer.label);
    return labels;
}

void expect_no_step(const Style& style) {
    const double trunk_mm = 7;
    const FlatModel model = draw_model(style, make_model_mesh(style), trunk_mm, {});
    const TrunkTop& top = model.model.top.value();
    const FlatFrame& frame = model.flat.frame;
    EXPECT_EQ(model.crown.foot_mm, frame.flat_from_world(top.position));
    EXPECT_NEAR(model.crown.scale * trunk_mm, 2 * top.radius * frame.mm_per_unit_at(top.position),
                1e-9);
    // A way straight up the page leads along the trunk.
    const Vec2 below = frame.flat_from_world(top.position - top.direction * 1e-3);
    const Vec2 way = model.crown.foot_mm - below;
    EXPECT_NEAR(std::atan2(way.x, -way.y), model.crown.turn_rad, 1e-4);
}

TEST(WholePlant, TheCrownGoesOnAsTheTrunkEnds) {
    Style style = mangrove();
    style.prop_root.primaries = 18;
    style.prop_root.trunk_bend = 3;
    for (const double azimuth : {0.0, 1.0, 4.0}) {
        style.flatten.camera.azimuth_rad = azimuth;
        expect_no_step(style);
    }
    EXPECT_NEAR(draw_model(style, make_model_mesh(style), 7, {}).crown.scale, 1,
                1e-9);                // the crown's own size counts
    style.flatten.mm_per_unit = 0.3;  // but for a scale that is said
    expect_no_step(style);
    style.flatten.camera.projection = Projection::perspective;
    expect_no_step(style);
}

TEST(WholePlant, SharesItsLayers) {
    const Picture picture = draw_picture(mangrove(), load);
    EXPECT_TRUE(check(picture.drawing).empty());
    const std::vector<std::string> labels = labels_of(picture.drawing);
    const auto at = [&](const char* label) {
        return std::find(labels.begin(), labels.end(), label) - labels.begin();
    };
    EXPECT_EQ(at("Ground"), 0);
    EXPECT_LT(at("Ground"), at("Roots"));
    EXPECT_LT(at("Roots"), at("Wood"));
    EXPECT_LT(at("Wood"), at("Leaves"));
    EXPECT_LT(at("Leaves"), std::ssize(labels));
}

TEST(WholePlant, ItsCountsAreThoseOfRootsAndCrown) {
    const TreeCounts counts = draw_picture(mangrove(), load).counts;
    ASSERT_TRUE(counts.roots);
    EXPECT_GT(counts.roots->roots, 10U);
    EXPECT_EQ(std::accumulate(counts.roots->by_order.begin(), counts.roots->by_order.end(),
                              std::size_t{0}),
              counts.roots->roots);
    EXPECT_GT(counts.branches, 50U);
    EXPECT_GT(counts.ornaments, 50U);
}

TEST(WholePlant, TheTrunkBelowIsOfOneTone) {
    Style style = mangrove();
    const auto inks_of_trunk = [&](double trunk_mm) {
        std::vector<Ink> inks;
        const FlatModel model = draw_model(style, make_model_mesh(style), trunk_mm, {});
        const auto visit = [&](const auto& self, const std::vector<Element>& elements,
                               bool is_trunk, Paint paint) -> void {
            for (const Element& element : elements) {
                if (const auto* group = std::get_if<Group>(&element)) {
                    Paint own = group->paint;
                    if (own.fill.kind == Ink::Kind::inherit) own.fill = paint.fill;
                    self(self, group->children, is_trunk || group->id.starts_with("trunk"), own);
                }
                const auto* shape = std::get_if<Shape>(&element);
                if (shape == nullptr || !(is_trunk || shape->id.starts_with("trunk"))) continue;
                Ink ink = shape->paint.fill;
                if (ink.kind == Ink::Kind::inherit) ink = paint.fill;
                if (std::find(inks.begin(), inks.end(), ink) == inks.end()) inks.push_back(ink);
            }
        };
        for (const Layer& layer : model.flat.layers)
            if (layer.label == "Fills") visit(visit, layer.children, false, layer.paint);
        return inks;
    };
    const std::vector<Ink> inks = inks_of_trunk(7);
    ASSERT_EQ(inks.size(), 1U);
    EXPECT_TRUE(inks[0] == Ink(style.palette.wood));
    EXPECT_GT(inks_of_trunk(0).size(), 1U);
}

}  // namespace
}  // namespace edaha
