// SPDX-License-Identifier: MIT
#include "write/gzip.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/run.h"

namespace edaha {
namespace {

std::string packed(const std::string& text, std::size_t piece) {
    std::string bytes;
    Gzip gzip([&](std::string_view part) { bytes += part; });
    for (std::size_t i = 0; i < text.size(); i += piece)
        gzip.write(text.substr(i, piece));
    gzip.finish();
    return bytes;
}

std::string error_of(const std::string& bytes, std::size_t most) {
    try {
        gunzip(bytes, most);
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

std::string sample() {
    std::string text;
    for (int i = 0; i < 40000; ++i)
        text += std::to_string(i * 7919 % 1009) + ' ';
    return text;
}

TEST(Gzip, IsReadByGzipItself) {
    const test::TemporaryFolder folder;
    test::write_whole(folder / "a.gz", packed(sample(), 1000));
    const test::RunResult result = test::run("gzip -dc " + test::quoted(folder / "a.gz"));
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, sample());
}

TEST(Gzip, HasNoDateAndNoSystem) {
    const std::string bytes = packed("<svg/>", 3);
    EXPECT_EQ(bytes.substr(0, 10), std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10));
}

TEST(Gzip, ComesBack) {
    EXPECT_EQ(gunzip(packed(sample(), 77), 1 << 20), sample());
    EXPECT_EQ(gunzip(packed("", 1), 0), "");
}

TEST(Gzip, DamageAndBombsAreErrors) {
    const std::string bytes = packed(sample(), 1000);
    EXPECT_EQ(error_of(bytes, 1000),
              "the packed file unpacks to more than the limit of 1000 bytes");
    EXPECT_EQ(error_of(bytes.substr(0, bytes.size() / 2), 1 << 20), "the packed file is damaged");
    std::string wrong = bytes;
    wrong[bytes.size() - 5] ^= 1;  // in the check sum
    EXPECT_EQ(error_of(wrong, 1 << 20), "the packed file is damaged");
}

}  // namespace
}  // namespace edaha
