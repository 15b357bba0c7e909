// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

void expect_first(std::string_view text, std::int32_t code, std::size_t bytes) {
    const Utf8Character first = first_character(text);
    EXPECT_EQ(first.code, code) << text;
    EXPECT_EQ(first.bytes, bytes) << text;
}

TEST(Utf8, ReadsOneToFourBytes) {
    expect_first("ab", 'a', 1);
    expect_first("\xc3\xa4x", 0xe4, 2);
    expect_first("\xe6\x9e\x9d", 0x679d, 3);
    expect_first("\xf0\x9f\x8c\xb3", 0x1f333, 4);
}

TEST(Utf8, TakesBytesThatStartNothingOneByOne) {
    for (const char* text : {"\x80", "\xff", "\xc3", "\xc3(", "\xe6\x9e", "\xc0\xaf",
                             "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80"}) {
        expect_first(text, kNoCharacter, 1);
    }
}

}  // namespace
}  // namespace edaha
