// SPDX-License-Identifier: MIT
#include "mesh/ply.h"

#include <bit>
#include <cstring>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "any_mesh.h"
#include "mesh/mesh_check.h"

namespace edaha {
namespace {

Mesh read(std::string_view bytes) {
    return read_ply(bytes, "a.ply").mesh;
}

std::string error_of(std::string_view bytes, const MeshReadParams& params = {}) {
    try {
        read_ply(bytes, "a.ply", params);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

std::string header(const std::string& format, const std::string& points, const std::string& faces) {
    return "ply\nformat " + format + " 1.0\nelement vertex " + points +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

constexpr const char* kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(ReadPly, text) {
    const Mesh mesh = read(header("ascii", "4", "2") + kSquare + "3 0 1 2\n3 0 2 3\n");
    EXPECT_EQ(mesh.points, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(mesh.parts.size(), 1U);
    EXPECT_EQ(mesh.parts[0].name, "mesh");
}

TEST(ReadPly, text_with_other_line_ends) {
    const std::string text = header("ascii", "4", "1") + kSquare + "4 0 1 2 3";
    for (const std::string end : {"\r\n", "\r"}) {
        std::string other;
        for (const char c : text)
            other += c == '\n' ? end : std::string(1, c);
        EXPECT_EQ(read(other).triangles.size(), 2U);
    }
}

template <typename T>
void append(std::string& bytes, T value, bool big) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big == (std::endian::native == std::endian::little)) {
        for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
            std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    }
    bytes.append(raw, sizeof(T));
}

// Every type, both byte orders, lists and elements that nobody knows.
TEST(ReadPly, binary) {
    for (const bool big : {false, true}) {
        std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                            "_endian 1.0\nelement odd 2\nproperty ushort a\n"
                            "property list int double b\nelement vertex 3\nproperty double x\n"
                            "property short y\nproperty uchar note\nproperty float z\n"
                            "property float s\nproperty float t\nelement fixed 3\n"
                            "property uint c\nelement face 1\nproperty char flag\n"
                            "property list ushort uint vertex_index\nend_header\n";
        for (std::int32_t i = 0; i < 2; ++i) {
            append(bytes, std::uint16_t{7}, big);
            append(bytes, i, big);
            for (std::int32_t k = 0; k < i; ++k)
                append(bytes, 1.5, big);
        }
        for (int i = 0; i < 3; ++i) {
            append(bytes, 0.25 * i, big);
            append(bytes, static_cast<std::int16_t>(-2 * i * i), big);
            append(bytes, std::uint8_t{200}, big);
            append(bytes, 1.5F, big);
            append(bytes, 0.5F, big);
            append(bytes, 0.125F * static_cast<float>(i), big);
        }
        for (int i = 0; i < 3; ++i)
            append(bytes, std::uint32_t{9}, big);
        append(bytes, std::int8_t{-1}, big);
        append(bytes, std::uint16_t{3}, big);
        for (std::uint32_t i = 0; i < 3; ++i)
            append(bytes, i, big);
        const Mesh mesh = read(bytes);
        EXPECT_EQ(mesh.points, (std::vector<Vec3>{{0, 0, 1.5}, {0.25, -2, 1.5}, {0.5, -8, 1.5}}));
        EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
        ASSERT_EQ(mesh.uv.size(), 1U);
        EXPECT_EQ(mesh.uv[0][2], glm::dvec2(0.5, 0.25));
        for (std::size_t size = 0; size < bytes.size(); ++size)
            EXPECT_NE(error_of(bytes.substr(0, size)), "none") << size << " bytes of it";
    }
}

TEST(ReadPly, says_what_is_wrong) {
    EXPECT_EQ(error_of(""), "a.ply:1:1: this is no PLY file (expected 'ply')");
    EXPECT_EQ(error_of("ply\n"), "a.ply:2:1: the header has no end_header");
    EXPECT_EQ(error_of("ply\nformat asci 1.0\n"),
              "a.ply:2:1: 'asci' is no format (expected ascii, binary_little_endian or "
              "binary_big_endian)");
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement face -1\n"),
              "a.ply:3:1: '-1' is no number of records (expected 0 to 999999999999)");
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement a 1\nproperty half x\n"),
              "a.ply:4:1: 'half' is no type (expected char, uchar, short, ushort, int, uint, "
              "float or double)");
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nend_header\n"), "a.ply:1:1: there are no faces");
    EXPECT_EQ(error_of("ply\nend_header\n"), "a.ply:1:1: the header names no format");
    const std::string square = header("ascii", "4", "1") + kSquare;
    EXPECT_EQ(error_of(square + "3 0 1 4"),
              "a.ply:7:1: there is no point 4 (the file has 4, counted from 0)");
    EXPECT_EQ(error_of(square + "2 0 1"), "a.ply:14:6: a face has 2 corners (expected 3 to 10000)");
    EXPECT_EQ(error_of(square + "3 0 1 -2"), "a.ply:14:9: a face's corner is no index of a point");
    EXPECT_EQ(error_of(square + "3 0 x 2"), "a.ply:14:5: 'x' is not a number");
    EXPECT_EQ(error_of(square + "3 0 1"),
              "a.ply:14:2: a list 'vertex_indices' has more values than the file holds");
}

TEST(ReadPly, reserves_nothing_for_promises) {
    EXPECT_EQ(error_of(header("binary_little_endian", "4000000000", "1")),
              "a.ply:3:1: 4000000000 records of 'vertex' need 48000000000 bytes at least, but 0 "
              "are left in the file");
    EXPECT_EQ(error_of(header("ascii", "0", "4000000000") + "3 0 1 2"),
              "a.ply:7:1: 4000000000 records of 'face' need 8000000000 bytes at least, but 7 are "
              "left in the file");
    MeshReadParams params;
    params.most_points = 3;
    EXPECT_EQ(error_of(header("ascii", "4", "1") + kSquare + "3 0 1 2", params),
              "a.ply:3:1: 4 records of 'vertex' are too many (expected at most 3)");
}

TEST(ReadPly, warns_of_colours) {
    const MeshInput input = read_ply(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n",
        "a.ply");
    ASSERT_EQ(input.warnings.size(), 1U);
    EXPECT_EQ(to_string(input.warnings[0]), "a.ply: colours of points and faces are not read");
}

// Any mesh of floats is read back as it was, with all that is told of its parts.
TEST(WritePly, is_read_back) {
    EXPECT_TRUE(rc::check([] {
        const Mesh mesh = test::any_mesh();
        const PlyKind kind = *rc::gen::element(PlyKind::binary, PlyKind::text);
        const Mesh back = read(write_ply(mesh, kind));
        RC_ASSERT(test::same_but_for_rounding(back, mesh));
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            RC_ASSERT(back.parts[p].order == mesh.parts[p].order);
            RC_ASSERT(back.parts[p].parent == mesh.parts[p].parent);
        }
    }));
}

}  // namespace
}  // namespace edaha
