// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <gtest/gtest.h>

namespace edaha {

TEST(Error, PlaceIsPrintedAsFarAsItIsKnown) {
    EXPECT_EQ(to_string(Problem{{"oak.xml", 12, 9}, "wrong"}), "oak.xml:12:9: wrong");
    EXPECT_EQ(to_string(Problem{{"oak.xml", 12, 0}, "wrong"}), "oak.xml:12: wrong");
    EXPECT_EQ(to_string(Problem{{"--set", 0, 0}, "wrong"}), "--set: wrong");
    EXPECT_EQ(to_string(Problem{{}, "wrong"}), "wrong");
}

TEST(Error, InputErrorSaysEveryProblem) {
    const InputError error({{{"a", 1, 2}, "x"}, {{"a", 3, 4}, "y"}});
    EXPECT_STREQ(error.what(), "a:1:2: x\na:3:4: y");
}

}  // namespace edaha
