// SPDX-License-Identifier: MIT
#include "base/fingerprint.h"

#include <initializer_list>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace edaha {
namespace {

std::string of(std::initializer_list<std::string_view> texts) {
    Fingerprint fingerprint;
    for (const std::string_view text : texts)
        fingerprint.add(text);
    return fingerprint.text();
}

TEST(Fingerprint, IsTheSameForTheSameTexts) {
    EXPECT_EQ(of({"oak", "7"}), of({"oak", "7"}));
    EXPECT_EQ(of({"oak"}).find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(of({}).size(), 16U);
}

TEST(Fingerprint, TellsOrderBoundsAndEmptyTextsApart) {
    const std::set<std::string> all{of({}),          of({""}),         of({"", ""}),
                                    of({"ab"}),      of({"a", "b"}),   of({"b", "a"}),
                                    of({"ab", ""}),  of({"", "ab"}),   of({std::string(1, '\0')}),
                                    of({"ab\0"}),    of({"12345678"}), of({"123456789"}),
                                    of({"87654321"})};
    EXPECT_EQ(all.size(), 12U);  // "ab\0" as a literal is "ab"
}

TEST(Fingerprint, FeelsEveryBit) {
    const std::string text(100, 'x');
    std::set<std::string> all{of({text})};
    for (std::size_t i = 0; i < text.size() * 8; ++i) {
        std::string changed = text;
        changed[i / 8] = static_cast<char>(changed[i / 8] ^ (1 << i % 8));
        all.insert(of({changed}));
    }
    EXPECT_EQ(all.size(), text.size() * 8 + 1);
}

}  // namespace
}  // namespace edaha
