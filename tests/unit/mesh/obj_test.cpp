// SPDX-License-Identifier: MIT
#include "mesh/obj.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "any_mesh.h"
#include "mesh/mesh_check.h"

namespace edaha {
namespace {

Mesh read(std::string_view text, const LoadMaterials& load_materials = {}) {
    return read_obj(text, "a.obj", {}, load_materials).mesh;
}

std::string error_of(std::string_view text, const MeshReadParams& params = {}) {
    try {
        read_obj(text, "a.obj", params);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, points_and_faces) {
    const Mesh mesh = read("v 1 2.5 -3e1\nv 0 0 +1 0.5\nv 7 8 9 1 0 0\nf 1 2 3\n");
    EXPECT_EQ(mesh.points, (std::vector<Vec3>{{1, 2.5, -30}, {0, 0, 1}, {7, 8, 9}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
    ASSERT_EQ(mesh.parts.size(), 1U);
    EXPECT_EQ(mesh.parts[0].name, "mesh");
    ASSERT_EQ(mesh.materials.size(), 1U);
    EXPECT_EQ(mesh.materials[0].name, "");
    EXPECT_FALSE(mesh.materials[0].colour.has_value());
    EXPECT_TRUE(mesh.uv.empty());
}

TEST(ReadObj, the_same_whatever_ends_the_lines) {
    const std::string text =
        std::string("# a comment\n\n") + kSquare + "f 1 2 \\\n 3 4 # end\nf 1 2 3";
    const Mesh mesh = read(text);
    EXPECT_EQ(mesh.triangles.size(), 3U);
    for (const std::string end : {"\r\n", "\r"}) {
        std::string other = "\xEF\xBB\xBF";
        for (const char c : text)
            other += c == '\n' ? end : std::string(1, c);
        EXPECT_EQ(read(other).triangles, mesh.triangles);
        EXPECT_EQ(read(other).points, mesh.points);
    }
}

TEST(ReadObj, indices_from_the_end_and_ahead) {
    const Mesh mesh = read(std::string("f 1 2 3\n") + kSquare + "f -4 -2 -1\n");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadObj, polygons) {
    const Mesh mesh = read("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n");
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_DOUBLE_EQ(mesh.points.size(), 4U);
}

TEST(ReadObj, places_in_uv) {
    const Mesh mesh = read(std::string(kSquare) +
                           "vt 0.5 0.25\nvt 1\nvn 0 0 1\nf 1/1/1 2/2 3\nf 1//1 3/-2/1 4\n");
    ASSERT_EQ(mesh.uv.size(), 2U);
    EXPECT_EQ(mesh.uv[0][0], glm::dvec2(0.5, 0.25));
    EXPECT_EQ(mesh.uv[0][1], glm::dvec2(1, 0));
    EXPECT_EQ(mesh.uv[0][2], glm::dvec2(0, 0));
    EXPECT_EQ(mesh.uv[1][1], glm::dvec2(0.5, 0.25));
}

TEST(ReadObj, parts_by_object_group_and_material) {
    const Mesh mesh = read(std::string(kSquare) +
                           "o tree\ng root\nusemtl bark\nf 1 2 3\nusemtl moss\nf 1 3 4\n"
                           "o other\nusemtl bark\nf 2 3 4\ng root\no tree\ng root\nf 1 2 4\n");
    ASSERT_EQ(mesh.parts.size(), 3U);
    EXPECT_EQ(mesh.parts[0].name, "tree/root");
    EXPECT_EQ(mesh.parts[1].name, "tree/root-2");
    EXPECT_EQ(mesh.parts[2].name, "other");
    EXPECT_EQ(mesh.part_of, (std::vector<std::uint32_t>{0, 1, 2, 0}));
    EXPECT_EQ(mesh.materials[mesh.parts[1].material].name, "moss");
    EXPECT_EQ(mesh.points.size(), 4U + 3 + 3) << "parts share no points";
    EXPECT_EQ(validate(mesh).shared_points, 0U);
}

TEST(ReadObj, colours_of_materials) {
    const LoadMaterials load = [](const std::string& name) -> std::optional<std::string> {
        if (name != "my tree.mtl") return std::nullopt;
        return "newmtl bark\nKd 1 0.5 0\nnewmtl none\nKd spectral x.rfl\nNs 3\n";
    };
    const Mesh mesh = read(std::string("mtllib my tree.mtl\n") + kSquare +
                               "usemtl bark\nf 1 2 3\nusemtl none\nf 1 3 4\n",
                           load);
    ASSERT_EQ(mesh.materials.size(), 2U);
    EXPECT_EQ(mesh.materials[0].colour, (Colour{255, 128, 0}));
    EXPECT_FALSE(mesh.materials[1].colour.has_value());
}

TEST(ReadObj, joins_points_of_open_edges) {
    const std::string soup = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 -0\n";
    EXPECT_EQ(read(soup + "f 1 2 3\nf 4 5 6").points.size(), 4U);
    MeshReadParams params;
    params.weld = false;
    EXPECT_EQ(read_obj(soup + "f 1 2 3\nf 4 5 6", "", params).mesh.points.size(), 6U);
    EXPECT_EQ(read(soup + "g a\nf 1 2 3\ng b\nf 4 5 6").points.size(), 6U) << "parts stay apart";
}

TEST(ReadObj, warns_once_of_what_it_does_not_know) {
    const MeshInput input = read_obj(
        std::string("mtllib gone.mtl\n") + kSquare + "curv 0 1\ncurv 0 1\ns 1\nl 1 2\nf 1 2 3\n",
        "a.obj");
    ASSERT_EQ(input.warnings.size(), 2U);
    EXPECT_EQ(to_string(input.warnings[0]), "a.obj:1:1: the materials 'gone.mtl' cannot be read");
    EXPECT_EQ(to_string(input.warnings[1]), "a.obj:6:1: 'curv' is not read");
}

TEST(ReadObj, says_what_is_wrong_and_where) {
    EXPECT_EQ(error_of(""), "a.obj:1:1: there are no faces");
    EXPECT_EQ(error_of("v 0 0 0\n"), "a.obj:2:1: there are no faces");
    EXPECT_EQ(error_of("v 0 x 0\nv 1 2\nv 1 2 1e999\n"),
              "a.obj:1:5: 'x' is not a number\na.obj:2:6: a number is missing\n"
              "a.obj:3:7: '1e999' is too large or too small (expected 1e-307 to 1e308, or 0)");
    const std::string square = kSquare;
    EXPECT_EQ(error_of(square + "f 1 2 0"),
              "a.obj:5:7: there is no point 0 (expected 1 to 4, or -4 to -1)");
    EXPECT_EQ(error_of(square + "f 1 2 -5"),
              "a.obj:5:7: there is no point -5 (expected 1 to 4, or -4 to -1)");
    EXPECT_EQ(error_of(square + "f 1 5 9"),
              "a.obj:5:7: there is no point 9 (expected 1 to 4, or -4 to -1)");
    EXPECT_EQ(error_of(square + "f 1/1 2 3"),
              "a.obj:5:5: there is no place in (u,v) 1 (there are none before it)");
    EXPECT_EQ(error_of(square + "f 1 2"), "a.obj:5:1: a face has 2 corners (expected 3 to 10000)");
    EXPECT_EQ(error_of(square + "f 1 2 3x"),
              "a.obj:5:7: '3x' is no corner (expected point, point/uv or point/uv/normal)");
    EXPECT_EQ(error_of(square + "f 1 2 3//"),
              "a.obj:5:7: '3//' is no corner (expected point, point/uv or point/uv/normal)");
    EXPECT_EQ(error_of(square + "f 1 2 99999999999999999999"),
              "a.obj:5:7: '99999999999999999999' is no corner (expected point, point/uv or "
              "point/uv/normal)");
}

TEST(ReadObj, keeps_to_its_limits) {
    MeshReadParams params;
    params.most_triangles = 2;
    EXPECT_EQ(error_of(std::string(kSquare) + "f 1 2 3 4\nf 1 2 3\n", params),
              "a.obj:6:1: there are more than 2 triangles");
    params.most_points = 3;
    EXPECT_EQ(error_of(kSquare, params), "a.obj:4:1: there are more than 3 points");
}

TEST(ReadObj, keeps_numbers_that_are_none_for_validate) {
    const Mesh mesh = read("v nan 0 0\nv 1 inf 0\nv 0 0 1\nf 1 2 3");
    EXPECT_EQ(validate(mesh).broken_points, 2U);
}

TEST(WriteObj, has_sharp_normals_on_a_box_and_smooth_ones_on_a_torus) {
    const auto count = [](const std::string& text, const std::string& keyword) {
        std::size_t found = 0;
        for (std::size_t at = text.find(keyword); at != std::string::npos;
             at = text.find(keyword, at + 1))
            ++found;
        return found;
    };
    EXPECT_EQ(count(write_obj(test::box(), "").obj, "\nvn "), 24U);
    EXPECT_EQ(count(write_obj(test::torus(30, 20), "").obj, "\nvn "), 600U);
}

// Any mesh of floats is read back as it was: points, triangles, parts, places, colours.
TEST(WriteObj, is_read_back) {
    EXPECT_TRUE(rc::check([] {
        const Mesh mesh = test::any_mesh();
        const ObjText text = write_obj(mesh, "m.mtl");
        const Mesh back = read_obj(text.obj, "", {}, [&](const std::string&) {
                              return std::optional<std::string>(text.mtl);
                          }).mesh;
        RC_ASSERT(test::same_but_for_rounding(back, mesh));
        RC_ASSERT(validate(back).sound());
    }));
}

}  // namespace
}  // namespace edaha
