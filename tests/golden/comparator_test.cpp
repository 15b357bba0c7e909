// SPDX-License-Identifier: MIT
// The comparator itself: that it is content with the same, and not with anything else.
#include <gtest/gtest.h>

#include "golden/golden.h"
#include "support/run.h"
#include "support/sample_drawing.h"
#include "write/format.h"

namespace edaha::test {
namespace {

Rendering render(const Drawing& drawing) {
    WriteParams params;
    params.png.width_px = 120;
    Rendering rendering;
    write_drawing(drawing, Format::svg, params, [&](std::string_view s) { rendering.svg += s; });
    write_drawing(drawing, Format::png, params, [&](std::string_view s) { rendering.png += s; });
    return rendering;
}

class Comparator : public testing::Test {
  protected:
    void SetUp() override { golden_.bless("sample", render(drawing_)); }

    std::string complaint(const Rendering& actual) const {
        return golden_.complaint("sample", actual, evidence_.path());
    }
    bool kept(const std::string& name) const { return std::filesystem::exists(evidence_ / name); }

    Drawing drawing_ = sample_drawing();
    TemporaryFolder folder_, evidence_;
    const GoldenFolder golden_{folder_.path()};
};

TEST_F(Comparator, IsContentWithTheSame) {
    EXPECT_EQ(complaint(render(drawing_)), "");
    EXPECT_FALSE(kept("sample-compared.png"));
}

TEST_F(Comparator, SeesOneChangedByte) {
    Rendering other = render(drawing_);
    other.svg[other.svg.find("width=\"") + 7] = '9';
    EXPECT_NE(complaint(other).find(": line 2\n  expected: <svg"), std::string::npos)
        << complaint(other);
    EXPECT_TRUE(kept("sample.svg"));
    EXPECT_FALSE(kept("sample-compared.png"));
}

TEST_F(Comparator, SeesAMissingEnd) {
    Rendering other = render(drawing_);
    other.svg.pop_back();
    EXPECT_NE(complaint(other).find("they end otherwise"), std::string::npos) << complaint(other);
}

TEST_F(Comparator, SeesAMissingLayerAndShowsIt) {
    drawing_.layers.pop_back();
    Rendering other = render(drawing_);
    other.svg = render(sample_drawing()).svg;
    EXPECT_NE(complaint(other).find(" % apart; see "), std::string::npos) << complaint(other);
    EXPECT_TRUE(kept("sample-compared.png"));
}

TEST_F(Comparator, AsksForWhatIsNotThere) {
    EXPECT_EQ(golden_.complaint("other", render(drawing_), evidence_.path()),
              "other: nothing is expected yet");
}

}  // namespace
}  // namespace edaha::test
