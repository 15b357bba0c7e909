// SPDX-License-Identifier: MIT
#include "write/pdf_objects.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

TEST(PdfText, AsciiStaysAsItIsAndTheRestIsUtf16) {
    EXPECT_EQ(pdf_text("Oak (1) \\ 2"), "(Oak \\(1\\) \\\\ 2)");
    EXPECT_EQ(pdf_text("\xc3\x84st"), "<feff00c400730074>");
    EXPECT_EQ(pdf_text("\xf0\x9f\x8c\xb3"), "<feffd83cdf33>");  // beyond 16 bits: a pair
    EXPECT_EQ(pdf_text("a\xff"), "<feff0061fffd>");
}

std::string file_of(std::string_view content) {
    std::string bytes;
    PdfObjects objects([&](std::string_view piece) { bytes += piece; });
    const int stream = objects.reserve();
    const int information = objects.write("<<>>");
    objects.write_stream(stream, {"", content});
    objects.finish(information, information);
    return bytes;
}

TEST(PdfObjects, TheTableSaysWhereObjectsStand) {
    const std::string bytes = file_of("q Q");
    const std::size_t table = bytes.find("xref\n0 3\n");
    ASSERT_NE(table, std::string::npos);
    EXPECT_NE(bytes.find("startxref\n" + std::to_string(table) + "\n%%EOF\n"), std::string::npos);
    for (int number = 1; number <= 2; ++number) {
        const std::size_t entry = table + 9 + 20 * static_cast<std::size_t>(number);
        const std::size_t place = std::stoul(bytes.substr(entry, 10));
        const std::string head = std::to_string(number) + " 0 obj\n";
        EXPECT_EQ(bytes.substr(place, head.size()), head);
    }
}

std::string identifier_of(const std::string& bytes) {
    return bytes.substr(bytes.find("/ID["));
}

TEST(PdfObjects, TheIdentifierFollowsFromTheContent) {
    EXPECT_EQ(file_of("q Q"), file_of("q Q"));
    EXPECT_NE(identifier_of(file_of("q Q")), identifier_of(file_of("Q q")));
}

}  // namespace
}  // namespace edaha
