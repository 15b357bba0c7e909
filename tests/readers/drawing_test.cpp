// SPDX-License-Identifier: MIT
#include <set>

#include "drawing/check.h"
#include "readers/pictures.h"

namespace edaha::test {
namespace {

class Drawings : public EveryStyle {};

TEST_P(Drawings, KeepTheContract) {
    for (const std::uint64_t seed : seeds(GetParam())) {
        const Picture picture = draw_tree(GetParam(), seed);
        for (const std::string& breach : check(picture.drawing))
            ADD_FAILURE() << "seed " << seed << ": " << breach;
        for (const Problem& warning : picture.warnings)
            ADD_FAILURE() << "seed " << seed << ": " << to_string(warning);
        EXPECT_GT(picture.counts.limbs + picture.counts.parts, 0U) << "seed " << seed;
    }
}

// What a person would call them; ids are the same with - for a blank.
const std::set<std::string> kLayerNames{
    "Ground",       "Wood behind",   "Leaves behind", "Blossom behind",
    "Fruit behind", "Wood",          "Leaves",        "Blossom",
    "Fruit",        "Roots",         "Root lines",    "Tree",
    "Tree lines",   "Sprigs behind", "Sprigs",        "Bark"};

TEST_P(Drawings, NameTheirLayers) {
    for (const std::uint64_t seed : seeds(GetParam())) {
        const Picture picture = draw_tree(GetParam(), seed);
        bool has_wood = false;  // or roots alone, or all in one
        for (const Layer& layer : picture.drawing.layers) {
            EXPECT_TRUE(kLayerNames.contains(layer.label)) << layer.label;
            has_wood |= layer.label == "Wood" || layer.label == "Roots" || layer.label == "Tree";
        }
        EXPECT_TRUE(has_wood) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Styles, Drawings, testing::ValuesIn(built_in_styles()), style_test_name);

}  // namespace
}  // namespace edaha::test
