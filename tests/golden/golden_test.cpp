// SPDX-License-Identifier: MIT
#include "golden/golden.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "app/leaf_shelf.h"
#include "style/style_xml.h"
#include "support/run.h"
#include "write/format.h"

namespace edaha::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> golden_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(TESTS_DIR "/golden/styles"))
        names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

// Without metadata, which holds every parameter there is: a new one changes no picture.
Rendering draw(const std::string& name) {
    const Catalogue catalogue;
    const std::string file = TESTS_DIR "/golden/styles/" + name + ".xml";
    const Style style = read_style(catalogue.find_style(file), catalogue);
    const Drawing drawing = draw_picture(style, LeafShelf(catalogue).loader()).drawing;
    WriteParams params;
    params.png.width_px = 200;
    Rendering rendering;
    write_drawing(drawing, Format::svg, params, [&](std::string_view s) { rendering.svg += s; });
    write_drawing(drawing, Format::png, params, [&](std::string_view s) { rendering.png += s; });
    return rendering;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, LooksAsExpected) {
    const GoldenFolder golden(TESTS_DIR "/golden/expected");
    const Rendering actual = draw(GetParam());
    const char* const bless = std::getenv("EDAHA_BLESS");
    if (bless != nullptr && std::string(bless) == "1") {
        golden.bless(GetParam(), actual);
        FAIL() << "blessed: look at the difference, and run again without EDAHA_BLESS";
    }
    const std::string evidence = testing::TempDir() + "edaha-golden";
    fs::create_directories(evidence);
    EXPECT_EQ(golden.complaint(GetParam(), actual, evidence), "")
        << "(EDAHA_BLESS=1 makes what is drawn now the expected picture)";
}

std::string test_name(const testing::TestParamInfo<std::string>& style) {
    std::string name = style.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Styles, Golden, testing::ValuesIn(golden_names()), test_name);

// What has no style any more is not expected either.
TEST(GoldenFiles, BelongToStyles) {
    const std::vector<std::string> names = golden_names();
    EXPECT_GE(names.size(), 8U);
    for (const auto& entry : fs::directory_iterator(TESTS_DIR "/golden/expected")) {
        const std::string stem = entry.path().stem().string();
        EXPECT_TRUE(std::ranges::binary_search(names, stem)) << entry.path();
    }
}

}  // namespace
}  // namespace edaha::test
