// SPDX-License-Identifier: MIT
#include "app/batch/shard.h"

#include <gtest/gtest.h>

#include "app/options.h"

namespace edaha {
namespace {

TEST(Shard, SharesAreEvenAndTogetherTheWhole) {
    for (const std::size_t variants : {0u, 1u, 5u, 12u, 100u}) {
        for (const std::size_t count : {1u, 2u, 7u, 13u}) {
            std::vector<int> drawn(variants, 0);
            for (std::size_t index = 1; index <= count; ++index) {
                const Shard shard{index, count};
                EXPECT_NEAR(static_cast<double>(shard.size(variants)),
                            static_cast<double>(variants) / static_cast<double>(count), 1);
                for (std::size_t place = 0; place < shard.size(variants); ++place)
                    ++drawn.at(shard.variant(place));
            }
            for (const int times : drawn)
                EXPECT_EQ(times, 1);
        }
    }
}

TEST(Shard, IsReadAndNamed) {
    EXPECT_TRUE(parse_shard("").is_all());
    EXPECT_EQ(shard_text(parse_shard("2/8")), "2/8");
    EXPECT_EQ(shard_infix(parse_shard("2/8")), ".2-of-8");
    EXPECT_EQ(shard_infix({}), "");
    for (const char* wrong :
         {"0/4", "5/4", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/9999", "1.5/2"})
        EXPECT_THROW(parse_shard(wrong), UsageError) << wrong;
}

TEST(Count, IsWithinItsBounds) {
    EXPECT_EQ(parse_count("-n", "12", 1, 12), 12u);
    const auto error = [](const std::string& text) -> std::string {
        try {
            parse_count("-n", text, 1, 12);
        } catch (const UsageError& wrong) {
            return wrong.what();
        }
        return "";
    };
    EXPECT_EQ(error("0"), "-n: '0' is out of range (expected 1 … 12)");
    EXPECT_EQ(error("13"), "-n: '13' is out of range (expected 1 … 12)");
    EXPECT_EQ(error("1.5"), "-n: '1.5' is not a whole number (expected 1 … 12)");
    EXPECT_EQ(error("-3"), "-n: '-3' is out of range (expected 1 … 12)");
}

}  // namespace
}  // namespace edaha
