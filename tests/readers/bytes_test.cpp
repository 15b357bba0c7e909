// SPDX-License-Identifier: MIT
// The same bytes: twice, and with any number of threads.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "readers/pictures.h"

namespace edaha::test {
namespace {

class Bytes : public EveryStyle {};

std::string svg_with_threads(int threads, const std::string& style, std::uint64_t seed) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return in_format(draw_tree(style, seed).drawing, Format::svg); });
}

TEST_P(Bytes, DoNotDependOnThreads) {
    for (const std::uint64_t seed : seeds(GetParam())) {
        const std::string one = svg_with_threads(1, GetParam(), seed);
        EXPECT_TRUE(one == svg_with_threads(1, GetParam(), seed)) << "twice, seed " << seed;
        EXPECT_TRUE(one == svg_with_threads(2, GetParam(), seed)) << "2 threads, seed " << seed;
        EXPECT_TRUE(one == svg_with_threads(5, GetParam(), seed)) << "5 threads, seed " << seed;
    }
}

// The paper's figures of surface growth are single trunks that leave nothing to chance.
TEST_P(Bytes, DependOnTheSeed) {
    const bool has_chance = !GetParam().starts_with("paper/surface-");
    const std::string one = svg_with_threads(2, GetParam(), 1);
    EXPECT_EQ(one != svg_with_threads(2, GetParam(), 2), has_chance);
}

INSTANTIATE_TEST_SUITE_P(Styles, Bytes, testing::ValuesIn(built_in_styles()), style_test_name);

}  // namespace
}  // namespace edaha::test
