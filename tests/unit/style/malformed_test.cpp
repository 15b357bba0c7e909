// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "base/error.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

const std::string kFolder = TESTS_DIR "/unit/style/malformed/";

// The messages of each file, to the letter; "@" is the folder.
const std::map<std::string, std::string> kMessages = {
    {"bad-name",
     "@bad-name.xml:1:7: tree.name: 'My Oak' is not a name (expected small letters, digits and "
     "hyphens)"},
    {"broken-attribute", "@broken-attribute.xml:2:18: malformed XML: broken attribute"},
    {"broken-base",
     "@broken-base.xml:2:9: page.margin: 'x' is not a number (expected 0 … 1000 mm)\n"
     "@not-a-number.xml:3:11: growth.energy: 'abc' is not a number (expected 1 … 1e6)"},
    {"broken-colour",
     "@broken-colour.xml:2:12: palette.leaf: 'green' is not a colour (expected #rrggbb)\n"
     "@broken-colour.xml:2:25: palette.wood: '#12345' is not a colour (expected #rrggbb)"},
    {"broken-items",
     "@broken-items.xml:2:9: burl.radus: no such parameter (did you mean 'radius'?)\n"
     "@broken-items.xml:2:21: burl.strength: 'abc' is not a number (expected -1 … 100)\n"
     "@broken-items.xml:3:9: burl.height: '-1' is out of range (expected 0 … 1e6 mm)\n"
     "@broken-items.xml:3:32: burl.core: is given twice\n"
     "@broken-items.xml:4:13: obstacle.shape: 'rood' is not known (expected plane, box, ball, rod, "
     "wire or mesh; did you mean 'rod'?)\n"
     "@broken-items.xml:4:26: obstacle.from: '1 2' is not a point (expected x y z, each -1e6 … 1e6 "
     "mm)\n"
     "@broken-items.xml:4:37: obstacle.to: '0 0 2e6' is out of range (expected x y z, each -1e6 … "
     "1e6 mm)"},
    {"broken-list",
     "@broken-list.xml:2:10: space.habit: '' is not a list of numbers (expected 1 to 32 numbers, "
     "each 0 … 180 degrees)"},
    {"broken-range",
     "@broken-range.xml:2:11: growth.share: '0.1,0.9' is not a range (expected low high, each 0.01 "
     "… 0.99)"},
    {"broken-rules",
     "@broken-rules.xml:3:7: rules: production 1: expected '->' here, not '>'\n"
     "@broken-rules.xml:5:4: rules: is given twice\n"
     "@broken-rules.xml:5:10: rules.name: no such attribute\n"
     "@broken-rules.xml:5:20: rules: production 1: expected '->' here, not the end of the line\n"
     "@broken-rules.xml:5:21: 'b' has no place in 'rules'\n"
     "@broken-rules.xml:6:10: 'x' has no place in 'burl'\n"
     "@broken-rules.xml:7:4: burls: no such group (did you mean 'burl'?)"},
    {"circle", "@circle-back.xml:1:16: tree.extends: 'circle.xml' extends this style itself"},
    {"circle-back", "@circle.xml:1:16: tree.extends: 'circle-back.xml' extends this style itself"},
    {"control", "@control.xml:1:23: byte 0x1B is not XML text in UTF-8"},
    {"control-reference", "@control-reference.xml:1:16: tree.title: 'a?b' is not XML text"},
    {"doctype", "@doctype.xml:1:11: a document type has no place in a style"},
    {"element-inside", "@element-inside.xml:2:12: 'energy' has no place in 'growth'"},
    {"empty", "@empty.xml:1:1: there is no <tree> in this file"},
    {"encoding", "@encoding.xml:1:3: the encoding 'ISO-8859-1' is not read (expected UTF-8)"},
    {"everything",
     "@everything.xml:1:2: tree.name: is missing\n"
     "@everything.xml:1:7: tree.nmae: no such attribute (did you mean 'name'?)\n"
     "@everything.xml:2:11: growth.energy: 'abc' is not a number (expected 1 … 1e6)\n"
     "@everything.xml:2:24: growth.typ: no such parameter (did you mean 'type'?)\n"
     "@everything.xml:2:32: text '5' has no place here\n"
     "@everything.xml:3:9: look.ground: 'hill' is not known (expected none, shadow, mound or "
     "water)\n"
     "@everything.xml:4:4: leafs: no such group (did you mean 'leaf'?)\n"
     "@everything.xml:5:12: palette.leaf: '#12' is not a colour (expected #rrggbb)"},
    {"given-twice",
     "@given-twice.xml:2:31: growth.energy: is given twice\n"
     "@given-twice.xml:3:4: growth: is given twice"},
    {"latin-1", "@latin-1.xml:2:14: byte 0xE9 is not XML text in UTF-8"},
    {"missing-base",
     "@missing-base.xml:1:16: tree.extends: cannot read '@gone.xml': No such file or directory"},
    {"models-together",
     "@models-together.xml:1:16: tree.models: energy and prism don't go together"},
    {"no-model",
     "@no-model.xml:1:16: tree.models: names no model (expected energy, prism, prop-root or "
     "surface)"},
    {"no-name", "@no-name.xml:1:2: tree.name: is missing"},
    {"not-a-number",
     "@not-a-number.xml:3:11: growth.energy: 'abc' is not a number (expected 1 … 1e6)"},
    {"not-whole",
     "@not-whole.xml:2:10: space.candidates: '2.5' is not a whole number (expected 1 … 256)"},
    {"only-comment", "@only-comment.xml:1:1: there is no <tree> in this file"},
    {"out-of-range",
     "@out-of-range.xml:2:11: growth.energy: '0.5' is out of range (expected 1 … 1e6)\n"
     "@out-of-range.xml:3:9: leaf.fan: '-10' is out of range (expected 0 … 180 degrees)"},
    {"palette-twice",
     "@palette-twice.xml:3:12: palette 'dark': is given twice\n"
     "@palette-twice.xml:4:12: palette.name: 'Dark Red' is not a name (expected small letters, "
     "digits and hyphens)"},
    {"reversed-range",
     "@reversed-range.xml:2:11: branch.turn: '45 -45' is a reversed range (expected low high, each "
     "-180 … 180 degrees)"},
    {"surface-together",
     "@surface-together.xml:1:16: tree.models: surface goes with no other model"},
    {"text-inside",
     "@text-inside.xml:2:3: text 'energy = 5' has no place here\n"
     "@text-inside.xml:3:11: text '5' has no place here"},
    {"two-roots", "@two-roots.xml:2:2: 'tree' stands behind the end of the style"},
    {"unclosed", "@unclosed.xml:3:3: malformed XML: a start tag and an end tag do not match"},
    {"unknown-attribute",
     "@unknown-attribute.xml:1:16: tree.titel: no such attribute (did you mean 'title'?)"},
    {"unknown-base", "@unknown-base.xml:1:16: tree.extends: there is no style 'no-such-tree'"},
    {"unknown-choice",
     "@unknown-choice.xml:2:9: look.wood: 'silhuette' is not known (expected solid, silhouette, "
     "outline or line; did you mean 'silhouette'?)"},
    {"unknown-flag",
     "@unknown-flag.xml:2:9: look.straight: 'true' is neither (expected yes or no)"},
    {"unknown-group",
     "@unknown-group.xml:2:4: grwoth: no such group (did you mean 'growth'?)\n"
     "@unknown-group.xml:3:4: roots: no such group"},
    {"unknown-leaf",
     "@unknown-leaf.xml:2:9: leaf.shape: there is no leaf 'oka' (did you mean 'oak'?)\n"
     "@unknown-leaf.xml:3:10: fruit.shape: there is no leaf './nut.svg'"},
    {"unknown-model",
     "@unknown-model.xml:1:16: tree.models: 'prisms' is not known (expected energy, prism, "
     "prop-root or surface) (did you mean 'prism'?)"},
    {"unknown-parameter",
     "@unknown-parameter.xml:2:11: growth.enery: no such parameter (did you mean 'energy'?)\n"
     "@unknown-parameter.xml:2:21: growth.colour: no such parameter"},
    {"wrong-root", "@wrong-root.xml:1:2: the root element is 'svg' (expected tree)"},
};

std::string messages(const std::string& name) {
    const Catalogue catalogue;
    std::string text = "read";
    try {
        read_style(catalogue.find_style(kFolder + name + ".xml"), catalogue);
    } catch (const InputError& error) {
        text = error.what();
    }
    for (std::size_t at = 0; (at = text.find(kFolder)) != std::string::npos;)
        text.replace(at, kFolder.size(), 1, '@');
    return text;
}

class Malformed : public testing::TestWithParam<std::string> {};

TEST_P(Malformed, IsRefusedWithEveryReason) {
    const auto expected = kMessages.find(GetParam());
    ASSERT_NE(expected, kMessages.end()) << messages(GetParam());
    EXPECT_EQ(messages(GetParam()), expected->second);
}

std::vector<std::string> files() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Style, Malformed, testing::ValuesIn(files()), test_name);

TEST(Malformed, EveryMessageHasItsFile) {
    EXPECT_EQ(files().size(), kMessages.size());
}

}  // namespace
}  // namespace edaha
