// SPDX-License-Identifier: MIT
#include "style/parameter_rows.h"

namespace edaha {
namespace {

constexpr const char* kOurs = "Edaha";

template <class Reach>
std::vector<Parameter> ornament_rows(const char* group, Reach reach) {
    using P = OrnamentParams;
    RowWriter rows(group, reach);
    // clang-format off
    rows.add(&P::shape, {"shape", kOurs,
        "drawing: a name (edaha leaves) or an SVG file; empty: none"});
    rows.add(&P::size_mm, {"size", mm(0.01, 1000), kOurs,
        "from its stem to its far end", {1.5, 7.5}});
    rows.add(&P::size_spread, {"size-spread", {0, 0.95}, kOurs,
        "sizes are size times 1 - spread to 1 + spread", {0, 0.8}});
    rows.add(&P::count, {"count", {0, 100}, kOurs, "mean number at a twig's end", {0, 6}});
    rows.add(&P::fan_rad, {"fan", degrees(0, 180), kOurs,
        "those at a twig's end fan out to either side by up to this", {0, 160}});
    rows.add(&P::along_mm, {"along", mm(0, 1000), kOurs,
        "spacing of further ones along the twigs; 0: none", {1.5, 12}});
    rows.add(&P::along_width_mm, {"along-width", mm(0, 1000), kOurs,
        "those grow on wood thinner than this", {0.3, 2}});
    rows.add(&P::along_angle_rad, {"along-angle", degrees(0, 180), kOurs,
        "angle between those and their twig", {10, 90}});
    rows.add(&P::scatter_mm, {"scatter", mm(0, 1000), kOurs,
        "distance from the twig that a cluster spreads over", {0, 4}});
    rows.add(&P::droop, {"droop", {0, 1}, kOurs, "how far they turn to hang straight down"});
    rows.add(&P::upright, {"upright", {0, 1}, kOurs, "how far they turn to stand straight up"});
    rows.add(&P::share, {"share", {0, 1}, kOurs, "part of the sites that bear one"});
    rows.add(&P::behind, {"behind", {0, 1}, kOurs, "part of them that is drawn behind the wood"});
    // clang-format on
    return rows.take();
}

}  // namespace

std::vector<Parameter> look_rows() {
    using P = LookParams;
    RowWriter rows(
        "look", [](auto& s) -> auto& { return s.look; });
    // clang-format off
    rows.add(&P::wood, {"wood", {"solid", "silhouette", "outline", "line"}, kOurs,
        "filled limbs, one filled shape, contours, or centre lines"});
    rows.add(&P::straight, {"straight", "paper 2",
        "limbs as straight sticks, as the paper draws them"});
    rows.add(&P::gnarl, {"gnarl", {0, 5}, kOurs,
        "sideways wander of a limb between its forks, part of the length", {0, 2}});
    rows.add(&P::sweep, {"sweep", {0, 1}, kOurs,
        "how far a child sets out along its parent before it turns"});
    rows.add(&P::fillet, {"fillet", {0, 10}, kOurs,
        "radius of a joint's fillets, in widths of the child", {0, 3}});
    rows.add(&P::tip, {"tip", {0, 1}, kOurs,
        "width of a limb's end, part of the width of its last branch"});
    rows.add(&P::min_width_mm, {"min-width", mm(0, 10), kOurs,
        "no twig is drawn thinner", {0, 1.2}});
    rows.add(&P::root_flare, {"root-flare", {0, 10}, kOurs,
        "how far the trunk widens at the ground, part of its width", {0, 2}});
    rows.add(&P::root_height, {"root-height", {0, 20}, kOurs,
        "height of that flare, in widths of the trunk", {0.5, 4}});
    rows.add(&P::stroke_mm, {"stroke", mm(0.001, 50), kOurs,
        "look outline: stroke of the contour", {0.1, 1}});
    rows.add(&P::back, {"back", {0, 1}, kOurs, "part of the boughs that stand behind the trunk"});
    rows.add(&P::marks, {"marks", {0, 100}, kOurs, "bark marks on 10 mm of limb", {0, 8}});
    rows.add(&P::mark_min_width_mm, {"mark-min-width", mm(0, 1000), kOurs,
        "limbs thinner than this bear no marks", {0.5, 4}});
    rows.add(&P::ground, {"ground", {"none", "shadow", "mound", "water"}, kOurs,
        "what the trunk stands on"});
    rows.add(&P::ground_width, {"ground-width", {0, 10}, kOurs,
        "width of the ground, part of the crown's", {0.3, 1.5}});
    // clang-format on
    return rows.take();
}

std::vector<Parameter> leaf_rows() {
    return ornament_rows(
        "leaf", [](auto& s) -> auto& { return s.leaf; });
}

std::vector<Parameter> blossom_rows() {
    return ornament_rows(
        "blossom", [](auto& s) -> auto& { return s.blossom; });
}

std::vector<Parameter> fruit_rows() {
    return ornament_rows(
        "fruit", [](auto& s) -> auto& { return s.fruit; });
}

std::vector<Parameter> palette_rows() {
    using P = Palette;
    RowWriter rows(
        "palette", [](auto& s) -> auto& { return s.palette; });
    // clang-format off
    rows.add(&P::paper, {"paper", kOurs, "the background, and what is seen through the crown"});
    rows.add(&P::wood, {"wood", kOurs, "trunk and boughs"});
    rows.add(&P::wood_light, {"wood-light", kOurs, "twigs"});
    rows.add(&P::wood_shade, {"wood-shade", kOurs, "the side of the wood away from the light"});
    rows.add(&P::wood_back, {"wood-back", kOurs, "boughs behind the trunk"});
    rows.add(&P::mark, {"mark", kOurs, "bark marks"});
    rows.add(&P::leaf_light, {"leaf-light", kOurs, "leaves in the light"});
    rows.add(&P::leaf, {"leaf", kOurs, "leaves"});
    rows.add(&P::leaf_shade, {"leaf-shade", kOurs, "leaves in the shade"});
    rows.add(&P::leaf_back, {"leaf-back", kOurs, "leaves behind the wood"});
    rows.add(&P::blossom_light, {"blossom-light", kOurs, "blossom in the light"});
    rows.add(&P::blossom, {"blossom", kOurs, "blossom"});
    rows.add(&P::blossom_shade, {"blossom-shade", kOurs, "blossom in the shade"});
    rows.add(&P::blossom_back, {"blossom-back", kOurs, "blossom behind the wood"});
    rows.add(&P::fruit_light, {"fruit-light", kOurs, "fruit in the light"});
    rows.add(&P::fruit, {"fruit", kOurs, "fruit"});
    rows.add(&P::fruit_shade, {"fruit-shade", kOurs, "fruit in the shade"});
    rows.add(&P::fruit_back, {"fruit-back", kOurs, "fruit behind the wood"});
    rows.add(&P::ground, {"ground", kOurs, "the ground"});
    rows.add(&P::ground_shade, {"ground-shade", kOurs, "the ground in the tree's shade"});
    rows.add(&P::strict, {"strict", kOurs,
        "leaf drawings take the nearest palette colours for their own: for few inks"});
    // clang-format on
    return rows.take();
}

std::vector<Parameter> page_rows() {
    using P = PageParams;
    RowWriter rows(
        "page", [](auto& s) -> auto& { return s.page; });
    // clang-format off
    rows.add(&P::size_mm, {"size", mm(0, 10000), kOurs,
        "longer side of the page; 0: the tree's own size", {60, 140}});
    rows.add(&P::margin_mm, {"margin", mm(0, 1000), kOurs, "empty border round the tree", {0, 40}});
    rows.add(&P::background, {"background", kOurs, "paint the paper"});
    // clang-format on
    return rows.take();
}

}  // namespace edaha
