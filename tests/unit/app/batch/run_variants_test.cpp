// SPDX-License-Identifier: MIT
#include "app/batch/run_variants.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

namespace edaha {
namespace {

DrawnVariant drawn(std::size_t index) {
    DrawnVariant variant;
    variant.rows = {std::to_string(index)};
    return variant;
}

bool never() {
    return false;
}

std::string error_of(const RunReport& report) {
    try {
        if (report.error) std::rethrow_exception(report.error);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(RunVariants, TakesThemInOrderWhateverTheJobs) {
    for (const std::size_t jobs : {1u, 2u, 7u}) {
        std::vector<std::string> taken;
        const RunReport report =
            run_variants({200, jobs, never}, drawn,
                         [&](DrawnVariant&& variant) { taken.push_back(variant.rows.front()); });
        EXPECT_EQ(report.done, 200u);
        EXPECT_EQ(error_of(report), "");
        ASSERT_EQ(taken.size(), 200u);
        for (std::size_t i = 0; i < taken.size(); ++i)
            EXPECT_EQ(taken[i], std::to_string(i));
    }
}

TEST(RunVariants, FewAreUnderWay) {
    std::atomic<int> under_way = 0, most = 0;
    run_variants(
        {500, 2, never},
        [&](std::size_t index) {
            most = std::max(most.load(), ++under_way);
            return drawn(index);
        },
        [&](DrawnVariant&&) { --under_way; });
    EXPECT_LE(most, 8);
}

TEST(RunVariants, StopsWhenItShall) {
    std::size_t taken = 0;
    const auto stop = [asked = std::make_shared<int>(0)] { return ++*asked > 10; };
    const RunReport report = run_variants({500, 2, stop}, drawn, [&](DrawnVariant&&) { ++taken; });
    EXPECT_EQ(taken, 10u);  // all that had begun
    EXPECT_EQ(report.done, 10u);
    EXPECT_EQ(error_of(report), "");
}

TEST(RunVariants, AfterAnErrorWhatIsDoneIsTaken) {
    std::vector<std::string> taken;
    std::atomic<std::size_t> begun = 0;
    const RunReport report = run_variants(
        {500, 2, never},
        [&](std::size_t index) {
            ++begun;
            if (index == 20 || index == 21) throw std::runtime_error(std::to_string(index));
            return drawn(index);
        },
        [&](DrawnVariant&& variant) { taken.push_back(variant.rows.front()); });
    EXPECT_EQ(error_of(report).substr(0, 1), "2");
    EXPECT_LT(begun, 40u);
    EXPECT_GE(taken.size(), 20u);
    EXPECT_EQ(report.done, taken.size());
    EXPECT_EQ(std::count(taken.begin(), taken.end(), "20"), 0);
}

TEST(RunVariants, WhenTakingFailsNoneIsTakenAfterwards) {
    std::size_t calls = 0;
    const RunReport report = run_variants({500, 2, never}, drawn, [&](DrawnVariant&&) {
        if (++calls == 5) throw std::runtime_error("full");
    });
    EXPECT_EQ(error_of(report), "full");
    EXPECT_EQ(calls, 5u);
    EXPECT_EQ(report.done, 4u);
}

}  // namespace
}  // namespace edaha
