// SPDX-License-Identifier: MIT
#include <sstream>

#include "readers/pictures.h"
#include "support/run.h"

namespace edaha::test {
namespace {

class Inkscape : public EveryStyle {};

constexpr double kMmOfPixel = 25.4 / 96;
constexpr double kRounding_mm = 0.01;

struct Box {
    double x = 0, y = 0, width = 0, height = 0;
};

std::istream& operator>>(std::istream& in, Box& box) {
    return in >> box.x >> box.y >> box.width >> box.height;
}

void expect_within_page(const Box& box, const Drawing& drawing) {
    EXPECT_GT(box.width, 0);
    EXPECT_GT(box.height, 0);
    EXPECT_GE(box.x * kMmOfPixel, -kRounding_mm);
    EXPECT_GE(box.y * kMmOfPixel, -kRounding_mm);
    EXPECT_LE((box.x + box.width) * kMmOfPixel, drawing.width_mm + kRounding_mm);
    EXPECT_LE((box.y + box.height) * kMmOfPixel, drawing.height_mm + kRounding_mm);
}

// Of all readers the slowest by far: a quarter of the seeds, all of them where EDAHA_SEEDS says so.
constexpr std::size_t kSeeds = 5;

// One process opens all the seeds, since its start takes longer than a file. It is asked for the
// box that each drawing fills, strokes included: ours must be within the page by its measure too.
TEST_P(Inkscape, OpensEverySeedWithoutAMessage) {
    const TemporaryFolder folder;
    std::string files;
    std::vector<Drawing> drawings;
    for (const std::uint64_t seed : seeds(GetParam(), kSeeds)) {
        drawings.push_back(draw_tree(GetParam(), seed).drawing);
        const std::string file = folder / (std::to_string(seed) + ".svg");
        write_whole(file, in_format(drawings.back(), Format::svg));
        files += ' ' + file;
    }
    // Without a desktop Inkscape warns of its list of recent files, whatever it opens.
    const RunResult result =
        run("{ inkscape -X -Y -W -H" + files +
            "; } 3>&1 1>&2 2>&3 | grep -v -e GtkRecentManager -e '^$' || true");
    EXPECT_EQ(result.out, "");
    std::istringstream numbers(result.err);
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        SCOPED_TRACE("seed " + std::to_string(seeds(GetParam(), kSeeds)[i]));
        Box box;
        ASSERT_TRUE(numbers >> box) << result.err;
        expect_within_page(box, drawings[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(Styles, Inkscape, testing::ValuesIn(built_in_styles()), style_test_name);

}  // namespace
}  // namespace edaha::test
